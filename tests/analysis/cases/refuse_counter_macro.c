/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* R506. Covers: row 65 of the construct table. */
void counter_macro(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse counter-macro
        h[s[i]] += __COUNTER__ + 0;
}
