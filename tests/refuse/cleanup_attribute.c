/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A call that is written only in an attribute.
// covers: row 14, row 63 of docs/constructs.md
void unlock(int *p);

/* The attribute calls `unlock` at the end of each iteration. */
void cleaned_up(int n, const int *k, int *h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        int z __attribute__((cleanup(unlock))) = 0;
        h[k[t]] += 1 + z;
    }
}
