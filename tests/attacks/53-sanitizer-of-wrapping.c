/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -O2 -fsanitize=integer -fno-sanitize-recover=all
// METHODS: auto localwrite binning
// COMPILERS: clang-19
// This sanitizer ends a program whose unsigned numbers wrap around, although that is legal. The program has
// no such operation, and the generated code must have none either.
#include <stdio.h>

enum { N = 5000, K = 60 };
static int k[N];
static double h[K], v[N];

static void sums(int n) {
    for (int t = 0; t < n; t++) // EXPECT: refuse option
        h[k[t]] += v[t];
}

int main(void) {
    for (int t = 0; t < N; t++) {
        k[t] = t * 7919 % K;
        v[t] = 1.0 / (1 + t);
    }
    for (int round = 0; round < 3; round++)
        sums(N);
    for (int i = 0; i < K; i++)
        printf("%a\n", (double)h[i]);
    return 0;
}
