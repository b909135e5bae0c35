/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -O2 -fopenmp
// METHODS: auto localwrite binning
// The name _Pragma is itself pasted together by ##.
#define PASTE(a, b) a##b
#include <stdio.h>

enum { N = 5000, K = 60 };
static int s[N];
static double h[K], e[N];

static void sums(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse
        PASTE(_Prag, ma)("omp atomic") h[s[t]] += e[t];
    }
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
