/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -O2 -fopenmp
// METHODS: auto localwrite binning
// A directive applies to the team of the thread that reaches it: outside parallel regions a team of one.
#include <stdio.h>

enum { N = 5000, K = 60 };
static int k[N];
static double h[K], v[N];

#define SINGLE _Pragma("omp single")

static double by_master(int t) {
    double x = 0;
#pragma omp master
    x = v[t];
    return x;
}

static double by_macro(int t) {
    double x = 0;
    SINGLE { x = v[t]; }
    return x;
}

static double plain(int t) {
    return v[t] * 0.5;
}

static void calls(int n) {
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
        h[k[t]] += by_master(t);
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
        h[k[t]] += by_macro(t);
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[k[t]] += plain(t);
}

int main(void) {
    for (int t = 0; t < N; t++) {
        k[t] = t * 7919 % K;
        v[t] = 1.0 / (1 + t);
    }
    for (int round = 0; round < 3; round++)
        calls(N);
    for (int i = 0; i < K; i++)
        printf("%a\n", (double)h[i]);
    return 0;
}
