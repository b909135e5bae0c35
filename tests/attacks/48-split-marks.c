/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// METHODS: auto localwrite binning
// A comment mark split across two lines: the next line is a directive, not part of a comment.
#include <stdio.h>

enum { N = 5000, K = 60 };
static int k[N];
static double h[K], v[N];
#define FACTOR 2

static void split(int n) {
    h[0] += FACTOR;
    for (int t = 0; t < n; t++) { // EXPECT: refuse
        h[k[t]] += v[t]; /\
/ see /*
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
