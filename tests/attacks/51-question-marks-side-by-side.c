/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -O2 -std=c11
// METHODS: auto localwrite binning
// With -std=c11 two question marks and a slash would be a trigraph for a backslash. The source writes them
// so that they are an ordinary string, which the output must keep.
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
