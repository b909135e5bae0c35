/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// For comparison with 71-inlining-by-387.c: no compiled function of this file computes in floating
// point. (atof of stdlib.h, and a function without callers, are not compiled.)
// CFLAGS: -O1 -mfpmath=387 -ffast-math
#include <stdio.h>
#include <stdlib.h>

enum { N = 20000, K = 300 };
static int subscript[N], counts[K];

static inline double never_called(double v) {
    return v * 0.1;
}

static void count(int n, const int *restrict s, int *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[s[t]] += abs(s[t]) & 3;
}

int main(void) {
    for (int i = 0; i < N; i++)
        subscript[i] = (int)(i * 7919LL % K);
    for (int round = 0; round < 3; round++)
        count(N - round, subscript, counts);
    for (int i = 0; i < K; i++)
        printf("%d\n", counts[i]);
    return 0;
}
