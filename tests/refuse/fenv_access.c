/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// With FENV_ACCESS the rounding mode and the exception flags are part of the result.
// covers: row 56 of docs/constructs.md
#pragma STDC FENV_ACCESS ON

void kernel(int n, const int *restrict s, double *restrict h, const double *e) {
    for (int t = 0; t < n; t++) // EXPECT: refuse fenv-access
        h[s[t]] += e[t];
}
