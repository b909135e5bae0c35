/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// FLAGS: -fno-strict-aliasing
// Without strict aliasing a store to a record may overwrite the pointer through which the records are found.
struct part {
    int cell, other;
};
struct species {
    int n;
    struct part *part;
};

void deposits(struct species *s, int n, float *restrict to) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-read
        s->part[i].cell += 1;
        to[s->part[i].cell] += 1;
    }
}
