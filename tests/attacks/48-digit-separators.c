/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -O2 -std=c2x
// METHODS: auto localwrite binning
// In C23 a quote between digits does not begin a character constant.
#include <stdio.h>

enum { N = 5000, K = 60 };
static int k[N];
static double h[K], v[N];
#define FACTOR 2

static void split(int n) {
    h[0] += FACTOR;
    for (int t = 0; t < n; t++) { // EXPECT: refuse
        h[k[t]] += v[t] * 1'0; // ' /*
#undef FACTOR
#define FACTOR 3
        h[k[t] / 2] += FACTOR; /* so */
    }
    h[1] += FACTOR;
#undef FACTOR
#define FACTOR 2
}

int main(void) {
    for (int t = 0; t < N; t++) {
        k[t] = t * 7919 % K;
        v[t] = 1.0 / (1 + t);
    }
    for (int round = 0; round < 3; round++)
        split(N);
    for (int i = 0; i < K; i++)
        printf("%a\n", h[i]);
    return 0;
}
