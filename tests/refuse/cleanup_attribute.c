/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A call that stands in an attribute only.
// covers: row 14, row 63 of docs/constructs.md
void unlock(int *p);

/* unlock is called at the end of each iteration. */
void cleaned_up(int n, const int *k, int *h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        int z __attribute__((cleanup(unlock))) = 0;
        h[k[t]] += 1 + z;
    }
}
