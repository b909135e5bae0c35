/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// OpenMP directives without effect, since the program is compiled without OpenMP: on the loop, in
// it, partly around it, and where _OPENMP selects the text.
// covers: row 55 of docs/constructs.md
#include "case.h"

#pragma GCC diagnostic ignored "-Wunknown-pragmas"

enum { N = 9000, M = 700 };
static int s[N];
static double w[N], h[M], g[M], f[M], e[M], d[M];

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
} // BINNED: 61

/* With OpenMP each thread would have its own `factor`. */
static double factor[2] = {2, 3};
#pragma omp threadprivate(factor)
static double c[M];

static void by_factor(void) {
    for (int t = 0; t < N; t++) // EXPECT: transformed
        c[s[t]] += w[t] * factor[t & 1];
    factor[0]++;
}

int main(void) {
    case_values(w, N);
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
