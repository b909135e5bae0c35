/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// covers: row 55 of docs/constructs.md
// CFLAGS: -fopenmp -std=gnu99
// FLAGS: -fopenmp -std=gnu99
// SEQUENTIAL: with OpenMP, the program's own directives may sum in any order
// MAY-RUN-SERIALLY: clauses require it, or the loop is inside a region
#include "case.h"

enum { N = 6000, M = 700 };
static int s[N];
static double w[N], h[M], g[M];
static long e[M];

static void never_parallel(int n) {
    int t;
#pragma omp parallel for if (0)
    for (t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp atomic
        h[s[t]] += w[t];
    }
}

static void by_one(int n) {
    int t;
#pragma omp parallel for num_threads(1)
    for (t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp atomic
        h[s[t]] -= w[t] * 0.25;
    }
}

/* Called inside a region as well, by each of its threads. */
static void anywhere(int n) {
    int t;
#pragma omp parallel for
    for (t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp atomic
        e[s[t]] += t % 7;
    }
}

static void reduced(int n, double *to) {
    int t;
#pragma omp parallel for reduction(+ : to[0 : M])
    for (t = 0; t < n; t++) // EXPECT: transformed
        to[s[t]] += w[t] * w[t];
}

static void in_regions(void) {
    int round;
#pragma omp parallel
    {
#pragma omp single
        reduced(N, g);
#pragma omp for
        for (round = 0; round < 4; round++)
            anywhere(N);
    }
}

int main(void) {
    int round;
    case_subscripts(s, N, M);
    case_values(w, N);
    case_values(g, M);
    for (round = 0; round < 3; round++) {
        never_parallel(N);
        by_one(N);
        anywhere(N);
        reduced(N, h);
        in_regions();
    }
    CASE_PRINT(h);
    CASE_PRINT(g);
    CASE_PRINT(e);
    return 0;
}
