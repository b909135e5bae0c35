/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -O2 -fopenmp
// METHODS: auto localwrite binning
// The operator _Pragma, split across two lines.
#include <stdio.h>

enum { N = 5000, K = 60 };
static int k[N];
static double h[K], v[N];

static void atomic(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse compiler
        _Prag\
ma("omp atomic") h[k[t]] += v[t];
    }
}

int main(void) {
    for (int t = 0; t < N; t++) {
        k[t] = t * 7919 % K;
        v[t] = 1.0 / (1 + t);
    }
    for (int round = 0; round < 3; round++)
        atomic(N);
    for (int i = 0; i < K; i++)
        printf("%a\n", (double)h[i]);
    return 0;
}
