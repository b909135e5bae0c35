/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * A histogram of doubles, parallelised by OpenMP directives. It is compiled unchanged, and as
 * translated by redcc.
 *
 *    openmp clause|atomic ITERATIONS ELEMENTS EXECUTIONS
 *
 * prints the milliseconds of the fastest execution in the second half of the executions, and a hash
 * of all bits of the results.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void by_clause(long n, long m, const int *restrict s, const double *restrict w,
                      double *restrict h) {
#pragma omp parallel for reduction(+ : h[:m])
    for (long t = 0; t < n; t++)
        h[s[t]] += w[t];
}

static void by_atomic(long n, const int *restrict s, const double *restrict w, double *restrict h) {
#pragma omp parallel for
    for (long t = 0; t < n; t++) {
#pragma omp atomic
        h[s[t]] += w[t];
    }
}

int main(int argc, char **argv) {
    if (argc != 5)
        return 2;
    const int is_clause = strcmp(argv[1], "clause") == 0;
    const long n = atol(argv[2]), m = atol(argv[3]), executions = atol(argv[4]);
    int *s = malloc((size_t)n * sizeof *s);
    double *w = malloc((size_t)n * sizeof *w), *h = calloc((size_t)m, sizeof *h);
    if (!s || !w || !h)
        return 1;
    uint64_t state = 1;
    for (long t = 0; t < n; t++) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        s[t] = (int)((state >> 33) % (uint64_t)m);
        w[t] = (double)(state >> 20) * 1e-9;
    }
    double least = 1e9;
    for (long i = 0; i < executions; i++) {
        const double began = now();
        if (is_clause)
            by_clause(n, m, s, w, h);
        else
            by_atomic(n, s, w, h);
        const double seconds = now() - began;
        if (2 * i >= executions && seconds < least)
            least = seconds;
    }
    uint64_t hash = 0;
    for (long i = 0; i < m; i++) {
        uint64_t bits;
        memcpy(&bits, &h[i], sizeof bits);
        hash = hash * 31 + bits;
    }
    printf("%.4f %016llx\n", 1e3 * least, (unsigned long long)hash);
    free(s), free(w), free(h);
    return 0;
}
