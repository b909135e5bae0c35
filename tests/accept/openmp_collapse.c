/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Compiled with OpenMP: a nest with `collapse` updates arrays in the nest's sequential order. Nine forms of nests.
// covers: row 55 of docs/constructs.md
// CFLAGS: -fopenmp
// FLAGS: -fopenmp
// SEQUENTIAL: with OpenMP, the program's own directives may sum in any order
#include "case.h"

enum { ROWS = 90, COLUMNS = 110, M = 300, P = 40 };
#define DEPTH 2
static int s[ROWS * COLUMNS], r[ROWS * COLUMNS], image[ROWS][COLUMNS];
static double w[ROWS * COLUMNS], x[M], h[M], g[M], e[M], c[M], q[M], u[M], d[M], sums[4];
static long counts[P];

static double pair(double a, double b) {
    const double f = a - b;
    return f * (0.5 + f * f);
}

/* counters declared in the headers, and inner loops without iterations in the first and last iterations */
static void pairs(int n, int m) {
#pragma omp parallel for collapse(2) schedule(dynamic, 16)
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = 0; j < m; j++) {
            const int a = s[i * m + j], b = r[i * m + j];
            const double force = pair(x[a], x[b]) * w[i * m + j];
#pragma omp atomic
            h[a] += force;
#pragma omp atomic
            h[b] -= force;
        }
}

/* counters of the function, which keep their values, and a depth that a macro defines */
static int counters(int n, int m) {
    int i = -7, j = -5, k = -3;
    double v = 0.25;
#pragma omp parallel for private(v) collapse( DEPTH )
    for (i = n - 1; i >= 0; i--) { // EXPECT: transformed
        for (j = 1; j < m; j += 2) {
            v = w[i * m + j] * 0.5;
#pragma omp critical(sums)
            {
                e[s[i * m + j]] += v;
                e[r[i * m + j]] += 2 * v;
            }
        }
    }
#pragma omp parallel for collapse(3) private(j)
    for (i = 0; i < n; i++) // EXPECT: transformed
        for (j = 0; j < m; ++j)
            for (k = 0; k < 3; k++)
#pragma omp atomic
                g[(s[i * m + j] + k) % M] += w[i * m + j] * (k + 0.5);
#ifdef _OPENMP
    return i == -7 && j == -5 && k == -3 && v == 0.25;
#else
    return 1;
#endif
}

/* the counters' values after the last iteration */
static int last(void) {
    int i = 5, j = 6;
#pragma omp parallel for collapse(2) lastprivate(i, j)
    for (i = 0; i < ROWS - 1; i += 2) // EXPECT: transformed
        for (j = 0; j < COLUMNS; j++)
#pragma omp atomic
            q[s[i * COLUMNS + j]] += w[i * COLUMNS + j];
    return i == ROWS && j == COLUMNS;
}

/* executed by the team of a region, with all of its threads and with nowait, next to a reduced scalar */
static double of_team(int n, int m) {
    int i = 4, j = 5;
    double sum = 0;
#pragma omp parallel
    {
#pragma omp for collapse(2) nowait
        for (i = 0; i < n; i++) // EXPECT: transformed
            for (j = 0; j < m; j++)
#pragma omp atomic
                u[s[i * m + j]] += w[i * m + j];
#pragma omp for collapse(2) reduction(+ : sum) schedule(static)
        for (int k = 0; k < n; k++) // EXPECT: transformed
            for (int l = 0; l < m; l++) {
                const double v = w[k * m + l];
                sum += v * v;
#pragma omp atomic
                u[r[k * m + l]] -= v;
            }
    }
#ifdef _OPENMP
    return i == 4 && j == 5 ? sum : 0;
#else
    return sum;
#endif
}

/* in a function that is called inside and outside a region */
static void orphan(int n, long *restrict to) {
    int y, z;
#pragma omp for collapse(2)
    for (y = 0; y < n; y++) // EXPECT: transformed
        for (z = 0; z < COLUMNS; z++) {
#pragma omp atomic
            to[image[y][z]]++;
        }
}

/* an inner bound that depends on the outer counter, and a collapse clause that names only the outer loop */
static void triangle(int n) {
#pragma omp parallel for collapse(1)
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = 0; j < i; j++)
#pragma omp atomic
            c[s[i]] += w[j];
#ifdef _OPENMP
#pragma omp parallel for collapse(2)
#endif
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = i; j < n; j++)
#pragma omp atomic
            c[r[j]] += w[i];
}

/* an array in the reduction clause */
static void clause(int n, int m) {
    int i, j;
#pragma omp parallel for collapse(2) reduction(+ : d)
    for (i = 0; i < n; i++) // EXPECT: transformed
        for (j = 0; j < m; j++)
            d[s[i * m + j]] += w[i * m + j];
}

int main(void) {
    int kept = 1;
    case_subscripts(s, ROWS * COLUMNS, M);
    case_subscripts(r, ROWS * COLUMNS, M);
    case_subscripts(image[0], ROWS * COLUMNS, P);
    case_values(w, ROWS * COLUMNS);
    case_values(x, M);
    for (int round = 0; round < 3; round++) {
        pairs(ROWS - round, COLUMNS);
        pairs(3, 0);
        kept &= counters(ROWS, COLUMNS - round);
        kept &= last();
        sums[round] = of_team(ROWS, COLUMNS);
#pragma omp parallel
        orphan(ROWS - round, counts);
        orphan(ROWS / 2, counts);
        triangle(ROWS - round);
    }
    clause(getenv("CASE_INTEGERS") ? 9 : 0, COLUMNS);
    CASE_PRINT(h);
    CASE_PRINT(g);
    CASE_PRINT(e);
    CASE_PRINT(c);
    CASE_PRINT(q);
    CASE_PRINT(u);
    CASE_PRINT(d);
    CASE_PRINT(sums);
    CASE_PRINT(counts);
    return !kept;
}
