/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -O2 -fsanitize=integer -fno-sanitize-recover=all
// METHODS: auto localwrite binning
// COMPILERS: clang-19
// The sanitizer ends programs whose unsigned numbers wrap around, which is legal: the program does nothing of
// the kind, so nothing that stands in it may.
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
