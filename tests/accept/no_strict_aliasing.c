/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The loop reads integers from the doubles that it updates, which -fno-strict-aliasing permits.
// CFLAGS: -fno-strict-aliasing
// INTEGERS: no
// MAY-RUN-SERIALLY: the second loop reads the memory that it writes
#include "case.h"

enum { N = 6000, M = 3000 };
static int s[N];
static double h[M];

__attribute__((noinline)) static void add(int n, const int *w, double *to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[s[t]] += w[t];
}

int main(void) {
    case_values(h, M);
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        add(N, s, h);
        CASE_PRINT(h);
        add(N, (const int *)h, h);
        CASE_PRINT(h);
    }
    return 0;
}
