/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -O2 -fopenmp
// METHODS: auto localwrite binning
// Directives that the loop's text does not show. One needs a team of one thread, another a statement after it.
#include <stdio.h>

enum { N = 5000, K = 60 };
static int k[N];
static double h[K], v[N];

#define EARLIER PRAGMA(omp atomic) /* uses PRAGMA, which is defined below */
#define PRAGMA(text) _Pragma(#text)
#define ATOMIC PRAGMA(omp atomic)
#define PASTED(which) ATO##which

static void single(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse directive-in-range
        double x = 0;
        PRAGMA(omp single) { x = v[t]; }
        h[k[t]] += x;
    }
}

static void atomic(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse directive-in-range
        ATOMIC
        h[k[t]] += v[t];
    }
}

static void earlier(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse directive-in-range
        EARLIER
        h[k[t]] += v[t];
    }
}

static void pasted(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse directive-in-range
        PASTED(MIC)
        h[k[t]] += v[t];
    }
}

static void held(int n) {
    if (n > 3)
        PRAGMA(GCC ivdep)
        for (int t = 0; t < n; t++) // EXPECT: refuse directive-in-range
            h[k[t]] += v[t];
}

static void none(int n) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[k[t]] += v[t];
}

int main(void) {
    for (int t = 0; t < N; t++) {
        k[t] = t * 7919 % K;
        v[t] = 1.0 / (1 + t);
    }
    for (int round = 0; round < 3; round++)
        (single(N), atomic(N), earlier(N), pasted(N), held(N), none(N));
    for (int i = 0; i < K; i++)
        printf("%a\n", (double)h[i]);
    return 0;
}
