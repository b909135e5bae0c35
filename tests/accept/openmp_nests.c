/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Compiled with OpenMP: a nest with `collapse` reduces scalars, in fixed blocks of the two loops' iterations.
// covers: row 55 of docs/constructs.md
// CFLAGS: -fopenmp
// FLAGS: -fopenmp
// SEQUENTIAL: with OpenMP, the program's own directives may sum in any order
// FIXED: blocks
#include "case.h"

enum { ROWS = 60, COLUMNS = 900, FEW = 3, MANY = 17000 };
#define DEPTH 2
#define UP_TO(j, m) for (j = 0; j < m; j++)
static double w[ROWS * COLUMNS], v[COLUMNS], cube[12][40][30];
static double of_file = 0.5;
static int k[COLUMNS];

/* counters declared in the headers: few long rows, many short ones, one iteration, none */
static double headers(int n, int m) {
    double sum = 0.25;
#pragma omp parallel for collapse(2) reduction(+ : sum)
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = 0; j < m; j++)
            sum += w[i * m + j] * v[j % COLUMNS];
    return sum;
}

/* counters of the function, private to each thread, in both directions and with steps */
static int counters(int n, int m) {
    int i = -7;
    unsigned j = 5;
    long c = 9;
    double sum = 0, least = 1e300;
#pragma omp parallel for collapse(DEPTH) reduction(+ : sum) reduction(min : least)
    for (i = n - 1; i >= 0; i -= 2) { // EXPECT: transformed
        for (j = 1; j <= (unsigned)m - 2; j += 3) {
            const double a = w[(unsigned)i * COLUMNS + j];
            sum += a * a;
            least = a < least ? a : least;
        }
    }
#pragma omp parallel for default(none) shared(w, v, n, m) private(i) collapse(2) reduction(- : sum) schedule(dynamic)
    for (i = 0; i < n; i++) // EXPECT: transformed
        for (c = m; c > 0; --c)
            sum -= w[i * COLUMNS + c - 1] * v[c - 1] * i;
    case_print("sum", &sum, sizeof sum);
    case_print("least", &least, sizeof least);
#ifdef _OPENMP
    return i == -7 && j == 5 && c == 9;
#else
    return 1;
#endif
}

/* values after the last iteration, which is in the last block */
static int last(void) {
    int i = 5, j = 6;
    double sum = 0, seen = 0;
#pragma omp parallel for collapse(2) lastprivate(i, j, seen) reduction(+ : sum)
    for (i = 0; i < FEW; i++) // EXPECT: transformed
        for (j = 0; j < MANY; j += 2) {
            seen = w[i * MANY + j];
            sum += seen;
        }
    case_print("sum", &sum, sizeof sum);
    case_print("seen", &seen, sizeof seen);
    return i == FEW && j == MANY;
}

/* No rows or no columns: `lastprivate` sets only the counters, as the loops would without their directive. OpenMP
 * leaves them unspecified. */
static int never(int n, int m) {
    int i = -5, j = -6;
    double sum = 0.25, seen = 5;
#pragma omp parallel for collapse(2) lastprivate(i, j, seen) reduction(+ : sum)
    for (i = 0; i < n; i++) // EXPECT: transformed
        for (j = 3; j < m; j++) {
            seen = w[i * MANY + j];
            sum += seen;
        }
    return sum == 0.25 && (getenv("CASE_INTEGERS") || (seen == 5 && i == (n > 0 ? n : 0) && j == (n > 0 ? 3 : -6))); /* unspecified */
}

/* three loops; long iterations; a triangle and headers that a macro makes, where only the outer loop is divided */
static double shapes(int n) {
    double sum = 0;
    int i, j, l;
#pragma omp parallel for collapse(3) reduction(+ : sum)
    for (i = 0; i < 12; i++) // EXPECT: transformed
        for (j = 0; j < 40; j++)
            for (l = 0; l < 30; l++)
                sum += cube[i][j][l] * (i + j - l);
#pragma omp parallel for collapse(2) reduction(+ : sum) private(l)
    for (i = 0; i < 2; i++) // EXPECT: transformed
        for (j = 0; j < 40; j++) {
            double row = 0;
            for (l = 0; l < 30; l++)
                row += cube[i][j][l] * w[l];
            sum += row * row;
        }
#ifdef _OPENMP
#pragma omp parallel for collapse(2) reduction(+ : sum)
#endif
    for (int a = 0; a < n; a++) // EXPECT: transformed
        for (int b = a; b < n; b++)
            sum += w[a * COLUMNS + b] * v[b];
#pragma omp parallel for collapse(2) reduction(+ : sum)
    for (i = 0; i < n; i++) // EXPECT: transformed
        UP_TO(j, 200)
            sum += w[i * COLUMNS + j] * v[n - i];
#pragma omp parallel for collapse(2) reduction(+ : sum)
    for (i = 0; i < FEW; i++) // EXPECT: transformed
#ifdef TWICE
        for (j = 0; j < 2 * n; j++)
#else
        for (j = 0; j < n; j++)
#endif
            sum += w[i * COLUMNS + j] * 3;
#pragma omp parallel for collapse(2) reduction(+ : sum)
    for (i = 0; i < FEW; i++) // EXPECT: transformed
        for (j = 0; j < n;
#define LESS 5
             j++)
            sum -= w[i * COLUMNS + j] * LESS;
    return sum;
}

/* A function that is called in a region, whose team executes the nest, and also outside. */
static void orphan(int n, int m) {
    int i, j;
#pragma omp for collapse(2) reduction(+ : of_file) nowait
    for (i = 0; i < n; i++) // EXPECT: transformed
        for (j = 0; j < m; j++)
            of_file += w[i * m + j] * 0.75;
}

static double of_team(int n, const int *m) {
    int i, j = 4, count = 0;
    double sum = 0;
#pragma omp parallel private(i) reduction(+ : count)
    for (int round = 0; round < 5; round++) {
#pragma omp for collapse(2) reduction(+ : sum) schedule(guided)
        for (i = 0; i < n; i++) // EXPECT: transformed
            for (j = 0; j < m[0]; j++) {
                if (k[j % COLUMNS] == 3)
                    continue;
                sum += w[i * m[0] + j] + round;
            }
#pragma omp for
        for (int c = 0; c < COLUMNS; c++)
            v[c] *= 0.5;
        count++;
    }
#ifdef _OPENMP
    return j == 4 ? sum : 0;
#else
    return sum;
#endif
}

int main(void) {
    int kept = 1;
    const int columns = COLUMNS;
    case_values(w, ROWS * COLUMNS);
    case_values(v, COLUMNS);
    case_values(cube[0][0], 12 * 40 * 30);
    case_subscripts(k, COLUMNS, 20);
    double sums[16] = {headers(FEW, MANY), headers(ROWS, COLUMNS), headers(MANY, FEW), headers(1, MANY), headers(0, MANY),
                       headers(MANY, 0), headers(100, 500), headers(5, 1), headers(1, 1), shapes(ROWS), shapes(1)};
    for (int round = 0; round < 3; round++) {
        kept &= counters(ROWS - 11 * round, COLUMNS - round);
        kept &= last() && never(-round, MANY) && never(round, 3 - round);
#pragma omp parallel
        orphan(FEW, MANY - round);
        orphan(ROWS, COLUMNS);
    }
    sums[11] = of_team(2, &columns);
    sums[12] = of_team(0, &columns);
    sums[13] = of_team(ROWS, &columns);
    CASE_PRINT(sums);
    case_print("of_file", &of_file, sizeof of_file);
    return !kept;
}
