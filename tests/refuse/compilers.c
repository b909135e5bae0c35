/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// redcc parses with clang, which sees another loop here than gcc, which may compile the output.
#include <stdlib.h>
#ifdef __clang__
#define VALUE(t) e[t]
#else
#define VALUE(t) h[t]
#endif

void kernel(int n, const int *restrict s, double *restrict h, const double *restrict e) {
    for (int t = 0; t < n; t++) // EXPECT: refuse compiler
        h[s[t]] += VALUE(t);
}
