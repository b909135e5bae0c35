/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The terms that assemble() sums: a triangle's forces at its corners, and a matrix for each pair
 *  of corners. The formulas have no physical meaning but cost as much as real ones. */
#ifndef ELEMENT_H
#define ELEMENT_H

#include "kernels.h"

static inline double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The force is 0 unless the weighted sum of the corners' positions is longer than 1. */
static inline void compute_element(const struct triangle *triangle, const double (*x)[3],
                                   double force[3][3], double derivative[3][3][3][3]) {
    double sum[3] = {0, 0, 0};
    for (int p = 0; p < 3; p++)
        for (int c = 0; c < 3; c++)
            sum[c] += triangle->weight[p] * x[triangle->corner[p]][c];
    const double square = dot(sum, sum), over = square > 1.0 ? 1.0 - 1.0 / square : 0.0;
    for (int p = 0; p < 3; p++)
        for (int r = 0; r < 3; r++) {
            force[p][r] = -over * triangle->weight[p] * sum[r];
            for (int q = 0; q < 3; q++)
                for (int c = 0; c < 3; c++)
                    derivative[p][q][r][c] =
                        -triangle->weight[p] * triangle->weight[q] *
                        (over * (r == c) + 2.0 * sum[r] * sum[c] / (square * square + 1.0));
        }
}

#endif
