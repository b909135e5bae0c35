/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -O2 -std=c11
// METHODS: auto localwrite binning
// A directive of C23: gcc ignores it in C11, clang obeys it.
#include <stdio.h>

enum { N = 5000, K = 60 };
static int s[N];
static double h[K], e[N];
#define B 1
static int count;

#if 0
#elifdef B
static double weight(int t) { return e[t]; }
#else
static double weight(int t) { count++; return e[t] * count; }
#endif

static void sums(int n) {
    for (int t = 0; t < n; t++) // EXPECT: refuse
        h[s[t]] += weight(t);
}

int main(void) {
    for (int t = 0; t < N; t++) {
        s[t] = t * 7919 % K;
        e[t] = 1.0 / (1 + t);
    }
    for (int round = 0; round < 3; round++)
        sums(N);
    for (int i = 0; i < K; i++)
        printf("%a\n", h[i]);
    return 0;
}
