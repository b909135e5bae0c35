/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The product with every block stored: regular, and twice the memory of half_product. */
#include "sparse_product.h"

void full_product(const block_matrix *restrict F, const double (*restrict x)[3],
                  double (*restrict y)[3]) {
#pragma omp parallel for schedule(static)
    for (int i = 0; i < F->row_count; i++) {
        double y0 = 0, y1 = 0, y2 = 0;
        for (int k = F->row_start[i]; k < F->row_start[i + 1]; k++) {
            const double(*a)[3] = F->value[k];
            const double *xj = x[F->column[k]];
            y0 += a[0][0] * xj[0] + a[0][1] * xj[1] + a[0][2] * xj[2];
            y1 += a[1][0] * xj[0] + a[1][1] * xj[1] + a[1][2] * xj[2];
            y2 += a[2][0] * xj[0] + a[2][1] * xj[1] + a[2][2] * xj[2];
        }
        y[i][0] = y0;
        y[i][1] = y1;
        y[i][2] = y2;
    }
}
