/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -O2 -std=c11
// METHODS: auto localwrite binning
// Two question marks and a slash would be a backslash where ISO's C is asked for: written as the source has
// them they are a string, and so they stay.
#include <stdio.h>

enum { N = 5000, K = 60 };
static int k[N];
static double h[K], v[N];

static void strings(int n) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[k[t]] += "?\?/ab?\?)x"[t % 7] * v[t];
}

int main(void) {
    for (int t = 0; t < N; t++) {
        k[t] = t * 7919 % K;
        v[t] = 1.0 / (1 + t);
    }
    for (int round = 0; round < 3; round++)
        strings(N);
    for (int i = 0; i < K; i++)
        printf("%a\n", (double)h[i]);
    return 0;
}
