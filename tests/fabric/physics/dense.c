/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "dense.h"

#include <math.h>
#include <stdlib.h>

double *dense_of(const block_matrix *half) {
    const int n = 3 * half->row_count;
    double *a = calloc((size_t)n * (size_t)n, sizeof *a);
    for (int i = 0; i < half->row_count; i++)
        for (int k = half->row_start[i]; k < half->row_start[i + 1]; k++)
            for (int r = 0; r < 3; r++)
                for (int c = 0; c < 3; c++) {
                    const int row = 3 * i + r, column = 3 * half->column[k] + c;
                    a[row * n + column] = half->value[k][r][c];
                    if (half->column[k] != i)
                        a[column * n + row] = half->value[k][r][c];
                }
    return a;
}

int dense_cholesky(double *a, int n) {
    for (int j = 0; j < n; j++) {
        for (int k = 0; k < j; k++)
            a[j * n + j] -= a[j * n + k] * a[j * n + k];
        if (!(a[j * n + j] > 0))
            return 1 + j;
        a[j * n + j] = sqrt(a[j * n + j]);
        for (int i = j + 1; i < n; i++) {
            for (int k = 0; k < j; k++)
                a[i * n + j] -= a[i * n + k] * a[j * n + k];
            a[i * n + j] /= a[j * n + j];
        }
    }
    return 0;
}

void dense_solve(double *a, int n, double *x, const double *b) {
    for (int i = 0; i < n; i++)
        x[i] = b[i];
    for (int j = 0; j < n; j++) {
        int pivot = j;
        for (int i = j + 1; i < n; i++)
            if (fabs(a[i * n + j]) > fabs(a[pivot * n + j]))
                pivot = i;
        for (int k = 0; k < n; k++) {
            const double swapped = a[j * n + k];
            a[j * n + k] = a[pivot * n + k];
            a[pivot * n + k] = swapped;
        }
        const double swapped = x[j];
        x[j] = x[pivot];
        x[pivot] = swapped;
        for (int i = 0; i < n; i++) {
            if (i == j)
                continue;
            const double factor = a[i * n + j] / a[j * n + j];
            for (int k = j; k < n; k++)
                a[i * n + k] -= factor * a[j * n + k];
            x[i] -= factor * x[j];
        }
    }
    for (int i = 0; i < n; i++)
        x[i] /= a[i * n + i];
}
