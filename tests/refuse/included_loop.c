/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A loop, and a function, that stand in another file: headers are not edited.
// covers: row 66
#include "included_function.h"

void no_range(int n, const int *restrict s, double *restrict h) { // EXPECT: refuse no-range
    for (int t = 0; t < n; t++)
#include "included_body.h"
}

void caller(int n, const int *restrict s, double *restrict h) {
    in_a_header(n, s, h);
    for (int t = 0; t < n; t *= 2) // EXPECT: refuse step
        h[s[t]]++;
}
