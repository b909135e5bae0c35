/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -O2 -std=gnu11
// METHODS: auto localwrite binning
// GNU C's raw strings: in them a line that looks like a directive is text.
#include <stdio.h>

enum { N = 5000, K = 60 };
static int k[N];
static double h[K], v[N];

static void raw(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse compiler
        h[k[t]] += R"(
#if 1
)"[1];
        h[k[t] / 2] += R"(
#endif
)"[2];
    }
}

int main(void) {
    for (int t = 0; t < N; t++) {
        k[t] = t * 7919 % K;
        v[t] = 1.0 / (1 + t);
    }
    for (int round = 0; round < 3; round++)
        raw(N);
    for (int i = 0; i < K; i++)
        printf("%a\n", (double)h[i]);
    return 0;
}
