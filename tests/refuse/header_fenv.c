/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A header of the program sets FENV_ACCESS: the rounding mode and the exception flags are part of the result.
// covers: row 56 of docs/constructs.md
// FLAGS: -w
#include "header_fenv.h"

void kernel(int n, const int *restrict s, double *restrict h, const double *e) {
    for (int t = 0; t < n; t++) // EXPECT: refuse fenv-access
        h[s[t]] += e[t];
}
