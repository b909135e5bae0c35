/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The advice for R506 (advice_updates.c explains BEFORE): in a file that names __COUNTER__, any macro may expand to it.
#include "case.h"
enum { N = 2000, ROWS = 80 };
static int s[N];
static double h[ROWS];

int main(void) {
    case_subscripts(s, N, ROWS);
#ifdef BEFORE
    for (int t = 0; t < N; t++) // BEFORE: counter-macro
        h[s[t]] += __COUNTER__;
#else
    const int number = __COUNTER__;
    for (int t = 0; t < N; t++) // EXPECT: transformed
        h[s[t]] += number;
#endif
    CASE_PRINT(h);
    return 0;
}
