/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Reason R506. Covers row 65 of docs/constructs.md. */
void counter_macro(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse counter-macro
        h[s[i]] += __COUNTER__ + 0;
}
