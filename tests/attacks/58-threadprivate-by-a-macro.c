/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -O2 -fopenmp
// METHODS: auto localwrite binning
// A macro expands to a directive that makes a variable thread-local.
#define PRAGMA(x) _Pragma(#x)
#include <stdio.h>

enum { N = 5000, K = 60 };
static int s[N];
static double h[K], e[N];
static double bias[2];
PRAGMA(omp threadprivate(bias))

static double weight(int t) { return e[t] * bias[t % 2]; }

static void sums(int n) {
    bias[0] += 1;
    bias[1] += 2;
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
