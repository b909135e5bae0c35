/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The advice of R506, followed (see advice.c): in a file that names __COUNTER__, any macro may expand to it.
// ADVICE: R506
#include "case.h"
enum { N = 2000, ROWS = 80 };
static int s[N];
static double h[ROWS];

int main(void) {
    const int number = __COUNTER__ + 3;
    case_subscripts(s, N, ROWS);
    for (int t = 0; t < N; t++) // EXPECT: transformed
        h[s[t]] += number;
    CASE_PRINT(h);
    return 0;
}
