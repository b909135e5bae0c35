/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The loops of openmp_asleep.c, translated without OpenMP but compiled with it. Then each original loop runs.
// covers: row 55 of docs/constructs.md
// CFLAGS: -fopenmp -DTWICE
// MAY-RUN-SERIALLY: with OpenMP the original loops run
#include "case.h"

enum { N = 9000, M = 700 };
static int s[N];
static int w[N], h[M], g[M], f[M], e[M], d[M];

static void on_it_and_in_it(void) {
#pragma omp parallel for schedule(static, 64)
    for (int t = 0; t < N; t++) { // EXPECT: transformed
#pragma omp atomic
        h[s[t]] += w[t];
    }
}

static void halves(void) {
#ifdef _OPENMP
#pragma omp parallel
    {
#pragma omp for
#endif
        for (int t = 0; t < N; t++) { // EXPECT: transformed
#pragma omp atomic
            g[s[t]] -= w[t];
        }
#ifdef _OPENMP
    }
#endif
}

static void chosen(void) {
    for (int t = 0; t < N; t++) { // EXPECT: transformed
#if defined(_OPENMP) && defined(TWICE)
        f[s[t]] += 2 * w[t];
#else
        f[s[t]] += w[t];
#endif
    }
}

static void in_a_region(void) {
#pragma omp parallel
#pragma omp single
    {
#pragma omp critical
        for (int t = 0; t < N; t++) // EXPECT: transformed
            e[s[t]] += w[t] * w[t];
    }
}

/* The last value of `at` is unused: the ignored clauses neither read nor copy it. */
static void with_clauses(void) {
    int at = 3;
#pragma omp parallel firstprivate(at)
#pragma omp single
    for (int t = 0; t < N; t++) { // EXPECT: transformed
        at = s[t];
        d[at] += w[t];
    }
#pragma omp parallel for lastprivate(at)
    for (int t = 0; t < 4; t++)
        at = t;
}

/* Each thread has its own `factor`. */
static int factor[2] = {2, 3};
#pragma omp threadprivate(factor)
static int c[M];

static void by_factor(void) {
    for (int t = 0; t < N; t++) // EXPECT: transformed
        c[s[t]] += w[t] * factor[t & 1];
    factor[0]++;
}

int main(void) {
    case_subscripts(w, N, 1000);
    case_subscripts(s, N, M);
    for (int round = 0; round < 3; round++) {
        on_it_and_in_it();
        halves();
        chosen();
        in_a_region();
        with_clauses();
        by_factor();
    }
    CASE_PRINT(h);
    CASE_PRINT(g);
    CASE_PRINT(f);
    CASE_PRINT(e);
    CASE_PRINT(d);
    CASE_PRINT(c);
    return 0;
}
