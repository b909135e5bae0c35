/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * The product with a symmetric matrix that is stored by half. Each stored block a, at (i, j), is
 * used twice: y_i += a x_j and y_j += a' x_i. Reading the matrix dominates the time, and half
 * storage halves it, at the price of the second, irregular update.
 */
#include "system.h"

void half_product(const block_matrix *restrict A, const double (*restrict x)[3],
                  double (*restrict y)[3]) {
    int i, j, k;
    double x0, x1, x2, y0, y1, y2;
    for (i = 0; i < A->row_count; i++) {
        k = A->row_start[i];
        x0 = x[i][0];
        x1 = x[i][1];
        x2 = x[i][2];
        y0 = A->value[k][0][0] * x0 + A->value[k][0][1] * x1 + A->value[k][0][2] * x2;
        y1 = A->value[k][1][0] * x0 + A->value[k][1][1] * x1 + A->value[k][1][2] * x2;
        y2 = A->value[k][2][0] * x0 + A->value[k][2][1] * x1 + A->value[k][2][2] * x2;
        for (k = A->row_start[i] + 1; k < A->row_start[i + 1]; k++) {
            j = A->column[k];
            y0 += A->value[k][0][0] * x[j][0] + A->value[k][0][1] * x[j][1] +
                  A->value[k][0][2] * x[j][2];
            y1 += A->value[k][1][0] * x[j][0] + A->value[k][1][1] * x[j][1] +
                  A->value[k][1][2] * x[j][2];
            y2 += A->value[k][2][0] * x[j][0] + A->value[k][2][1] * x[j][1] +
                  A->value[k][2][2] * x[j][2];
            y[j][0] += A->value[k][0][0] * x0 + A->value[k][1][0] * x1 + A->value[k][2][0] * x2;
            y[j][1] += A->value[k][0][1] * x0 + A->value[k][1][1] * x1 + A->value[k][2][1] * x2;
            y[j][2] += A->value[k][0][2] * x0 + A->value[k][1][2] * x1 + A->value[k][2][2] * x2;
        }
        y[i][0] += y0;
        y[i][1] += y1;
        y[i][2] += y2;
    }
}
