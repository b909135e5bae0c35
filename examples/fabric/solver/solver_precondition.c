/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "solver_precondition.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/matrix3.h"
#include "base/vector.h"

/* Computes the inverse of a symmetric positive definite matrix, by its cofactors. A matrix whose
 * leading minors show that it is not positive definite (Sylvester's criterion) gives a multiple of
 * the identity, so that conjugate gradients detect that A is not positive definite. A matrix of 0
 * gives 0. */
static void invert(const double a[3][3], double inverse[3][3]) {
    const double minor = a[0][0] * a[1][1] - a[0][1] * a[0][1];
    double column[3][3];
    vector_cross(a[1], a[2], column[0]);
    vector_cross(a[2], a[0], column[1]);
    vector_cross(a[0], a[1], column[2]);
    const double determinant = vector_dot(a[0], column[0]);
    const int definite = a[0][0] > 0 && minor > 0 && determinant > 0 && isfinite(determinant);
    const double size = fabs(a[0][0]) + fabs(a[1][1]) + fabs(a[2][2]);
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++)
            inverse[r][c] = definite               ? column[c][r] / determinant
                            : (r == c && size > 0) ? 1 / size
                                                   : 0;
}

static void invert_free(const double a[3][3], const double S[3][3], int given, double out[3][3]) {
    double half[3][3], within[3][3], inverse[3][3];
    if (given == 0) {
        invert(a, out);
        return;
    }
    matrix3_multiply(S, a, half);
    matrix3_multiply(half, S, within);
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++)
            within[r][c] += (r == c ? 1.0 : 0.0) * a[0][0] - a[0][0] * S[r][c];
    invert(within, inverse);
    matrix3_multiply(S, inverse, half);
    matrix3_multiply(half, S, out);
}

void preconditioner_build(const block_matrix *A, const constraints *c, double (*inverse)[6]) {
    assert(A->row_count == c->count);
#pragma omp parallel for schedule(static)
    for (int i = 0; i < A->row_count; i++) {
        double P[3][3];
        invert_free((const double(*)[3])A->value[A->row_start[i]], constraint_projection(c, i),
                    c->given[i], P);
        for (int r = 0, m = 0; r < 3; r++)
            for (int k = r; k < 3; k++, m++)
                inverse[i][m] = c->given[i] < 3 ? (P[r][k] + P[k][r]) / 2 : 0;
    }
}

void prefiltered_block(const block_matrix *A, const constraints *c, int i, int k,
                       double out[3][3]) {
    assert(k >= A->row_start[i] && k < A->row_start[i + 1]);
    const int j = A->column[k];
    if (c->given[i] == 0 && c->given[j] == 0) {
        memcpy(out, A->value[k], sizeof(double[3][3]));
        return;
    }
    double half[3][3];
    matrix3_multiply(constraint_projection(c, i), (const double(*)[3])A->value[k], half);
    matrix3_multiply_transposed((const double(*)[3])half, constraint_projection(c, j),
                                out); /* S' = S */
    if (i != j)
        return;
    for (int r = 0; r < 3; r++)
        for (int s = 0; s < 3; s++)
            out[r][s] += A->value[k][0][0] * ((r == s ? 1 : 0) - constraint_projection(c, i)[r][s]);
}
