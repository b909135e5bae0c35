/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -O2 -fopenmp
// METHODS: auto localwrite binning
// A macro that expands to a pragma is defined and used under two spellings of one name.
#define \u00e9t\u00e9 _Pragma("omp master")
#include <stdio.h>

enum { N = 5000, K = 60 };
static int s[N];
static double h[K], e[N];

static double weight(int t) {
    double r = 0;
    été r = e[t];
    return r;
}

static void sums(int n) {
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
