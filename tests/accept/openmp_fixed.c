/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Compiled with OpenMP: arrays of the clause `reduction` are updated in a fixed order, with the same bits at every
// number of threads and in every run. With REDCC_ORDER=serial it is the sequential order. Eleven forms of loops.
// covers: row 55 of docs/constructs.md
// CFLAGS: -fopenmp
// FLAGS: -fopenmp
// SEQUENTIAL: with OpenMP, the program's own directives may sum in any order
// FIXED: 31 38 48 55 64 73 82 93 105 126
// MAY-RUN-SERIALLY: one loop is executed inside a region
#include "case.h"

enum { N = 24000, M = 300, ROWS = 90 };
static int s[N], r[N], k[N];
static double w[N], x[M], g[M], mass[M], product[M], h[3 * M], row[ROWS][3], nodes[M], field[M], team[M], total, little;
static float grey[M];
static unsigned bits[M];
static long counts[M];
static int least[M], most[M];

static int many = 1; /* the condition of a directive's `if` clause */
int omp_get_max_threads(void);

static double pair(double a, double b) {
    const double d = a - b;
    return d * (0.5 + d * d);
}

/* an array section of a pointer */
static void histogram(int n, int m, const int *restrict at, const double *restrict v, double *restrict to) {
#pragma omp parallel for reduction(+ : to[:m])
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[at[t]] += v[t];
}

/* a whole array, updated for both ends of each pair */
static void pairs(int n) {
#pragma omp parallel for schedule(dynamic, 16) reduction(+ : g) if (many)
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double f = pair(x[s[t]], x[r[t]]) * w[t];
        g[s[t]] += f;
        g[r[t]] -= f;
    }
}

/* a part of an array */
static void shifted(int n, int first) {
#pragma omp parallel for reduction(- : h[first : 2 * M])
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[first + s[t] + M * (t & 1)] -= w[t] * 0.75;
}

/* two arrays of different types */
static void two(int n, float *restrict light) {
#pragma omp parallel for reduction(+ : light[0 : M], mass[0 : M])
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        light[s[t]] += (float)w[t];
        mass[r[t]] += w[t] * w[t];
    }
}

/* an array of rows */
static void rows(int n, double (*restrict to)[3]) {
#pragma omp parallel for reduction(+ : to[0:ROWS][:3])
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < 3; c++)
            to[k[t]][c] += w[t] * (c + 0.75);
}

/* reductions by min, max and * */
static void extremes(int n, int *restrict low, int *restrict high) {
#pragma omp parallel for reduction(min : low[:M]) reduction(max : high[:M]) \
    reduction(* : product)
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        low[s[t]] = k[t] < low[s[t]] ? k[t] : low[s[t]];
        high[r[t]] = k[t] > high[r[t]] ? k[t] : high[r[t]];
        product[s[t]] *= 1 + w[t] * little;
    }
}

static void integers(int n) {
#pragma omp parallel for reduction(+ : counts) reduction(^ : bits[0:M]) num_threads(5) if (n > 10)
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        counts[s[t]] += k[t];
        bits[r[t]] ^= (unsigned)k[t] << (t & 15);
    }
}

/* private variables and inner loops */
static double heavy(int n, double *restrict to) {
    double v, last = 0;
    int j;
#pragma omp parallel for private(v, j) lastprivate(last) reduction(+ : to[:M])
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (j = 0, v = 0; j < 4; j++)
            v += pair(x[(s[t] + j) % M], w[t]);
        to[s[t]] += v;
        last = v;
    }
    return last;
}

/* executed by each thread of a region, and outside a region */
static void anywhere(int n, double *restrict to) {
#pragma omp parallel for reduction(+ : to[:M])
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[r[t]] += w[t] * 1.25;
}

/* a scalar in addition to the array: both in the sequential order */
static void with_sum(int n) {
    double sum = 0;
#pragma omp parallel for reduction(+ : sum, nodes)
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double v = w[t] * w[t];
        nodes[s[t]] += v;
        sum += v;
    }
    total += sum;
}

/* The team of the enclosing region executes the loop. */
static void of_team(int n, double *restrict to) {
#pragma omp parallel
    {
#pragma omp for reduction(+ : to[:M])
        for (int t = 0; t < n; t++) // EXPECT: transformed
            to[s[t]] -= w[t] * 0.25;
#pragma omp for
        for (int i = 0; i < M; i++)
            to[i] *= 0.5;
    }
}

int main(void) {
    static double apart[16][M];
    case_subscripts(s, N, M);
    case_subscripts(r, N, M);
    case_subscripts(k, N, ROWS);
    case_values(w, N);
    case_values(x, M);
    for (int i = 0; i < M; i++) {
        nodes[i] = i % 3 ? -0.0 : 1;
        product[i] = 1;
    }
    little = getenv("CASE_INTEGERS") ? 0 : 0.001;
#ifdef _OPENMP
    many = omp_get_max_threads() > 1;
#endif
    double last = 0;
    for (int round = 0; round < 4; round++) {
        const int n = round == 3 ? N : N / 2 + 7 * round;
        histogram(n, M, s, w, field);
        histogram(n / 2, M / 2, k, w, field);
        pairs(n);
        shifted(n, round * 100);
        two(n, grey);
        rows(n, row);
        extremes(n, least, most);
        integers(n);
        last += heavy(n, mass);
#pragma omp parallel for
        for (int i = 0; i < 16; i++)
            anywhere(n, apart[i]);
        with_sum(n);
        anywhere(n, nodes);
        of_team(n, team);
    }
    CASE_PRINT(field);
    CASE_PRINT(g);
    CASE_PRINT(h);
    CASE_PRINT(grey);
    CASE_PRINT(mass);
    CASE_PRINT(row);
    CASE_PRINT(least);
    CASE_PRINT(most);
    CASE_PRINT(product);
    CASE_PRINT(counts);
    CASE_PRINT(bits);
    CASE_PRINT(apart);
    CASE_PRINT(nodes);
    CASE_PRINT(team);
    case_print("last", &last, sizeof last);
    case_print("total", &total, sizeof total);
    return 0;
}
