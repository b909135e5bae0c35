/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Reason R507. Covers row 56 of docs/constructs.md. */
#pragma STDC FENV_ACCESS ON
void environment(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse fenv-access
        h[s[i]] += 1.0;
}
