/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Compiled with OpenMP: conjugate gradients in one region, for a symmetric matrix of which one half is stored. The
// product keeps the order of its atomic updates; dot products are reduced in fixed blocks.
// covers: row 55 of docs/constructs.md
// CFLAGS: -fopenmp
// FLAGS: -fopenmp
// SEQUENTIAL: with OpenMP, the program's own directives may sum in any order
// FIXED: blocks
#include "case.h"

#ifndef ROWS
#define ROWS 3000
#endif
enum { EACH = 8, M = ROWS * EACH };
static int row[M], column[M];
static double entry[M], diagonal[ROWS], b[ROWS], x[ROWS], r[ROWS], p[ROWS], q[ROWS];
static double rho, product;

/* Returns the number of steps after which the squared residual is below `least`. */
static int solve(int n, int m, double least) {
    int steps = 0;
    rho = 0;
#pragma omp parallel
    {
        double alpha, before;
#pragma omp for reduction(+ : rho)
        for (int i = 0; i < n; i++) { // EXPECT: transformed
            x[i] = 0;
            r[i] = p[i] = b[i];
            rho += r[i] * r[i];
        }
        while (rho > least) {
            before = rho;
#pragma omp barrier
#pragma omp single
            {
                rho = product = 0;
                steps++;
            }
#pragma omp for
            for (int i = 0; i < n; i++)
                q[i] = diagonal[i] * p[i];
#pragma omp for
            for (int k = 0; k < m; k++) { // EXPECT: transformed
                const int i = row[k], j = column[k];
#pragma omp atomic
                q[i] += entry[k] * p[j];
#pragma omp atomic
                q[j] += entry[k] * p[i];
            }
#pragma omp for reduction(+ : product)
            for (int i = 0; i < n; i++) // EXPECT: transformed
                product += p[i] * q[i];
            alpha = before / product;
#pragma omp for reduction(+ : rho)
            for (int i = 0; i < n; i++) { // EXPECT: transformed
                x[i] += alpha * p[i];
                r[i] -= alpha * q[i];
                rho += r[i] * r[i];
            }
#pragma omp for
            for (int i = 0; i < n; i++)
                p[i] = r[i] + rho / before * p[i];
        }
    }
    return steps;
}

int main(void) {
    if (getenv("CASE_INTEGERS")) // its quotients are not integers
        return 0;
    case_subscripts(column, M, ROWS);
    case_values(entry, M);
    case_values(b, ROWS);
    for (int i = 0; i < ROWS; i++)
        diagonal[i] = 0.01;
    for (int k = 0; k < M; k++) {
        const double size = entry[k] < 0 ? -entry[k] : entry[k];
        row[k] = k / EACH;
        diagonal[row[k]] += size * (row[k] == column[k] ? 3 : 1);
        diagonal[column[k]] += size;
    }
    const int steps = solve(ROWS, M, 1e-16);
    CASE_PRINT(x);
    case_print("steps", &steps, sizeof steps);
    case_print("rho", &rho, sizeof rho);
#ifdef SAY
    printf("%d steps\n", steps);
#endif
    return 0;
}
