/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// As in own_options.c, but a pragma sets the options.
// covers: row 33, row 56 of docs/constructs.md
#pragma GCC optimize("O3")
void by_pragma(int n, double *h, const double *x) {
    for (int t = 0; t < n; t++) // EXPECT: refuse index-too-dear
        h[(int)(x[t] * 10.0 + x[t])] += 1;
}
