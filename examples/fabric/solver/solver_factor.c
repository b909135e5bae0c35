/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "solver_factor.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/matrix3.h"
#include "solver_precondition.h"

/* Incomplete factorisation breaks down if it reduces a pivot to less than this fraction of the
 * diagonal: the factor would be nearly singular. */
static const double least_pivot = 1e-2;
/* The first shift; each breakdown doubles it. With 0.001 and 0.01 some matrices of the scene
 * `hanging` broke down, with 0.1 none did. */
static const double first_shift = 0.05;
/* Over-relaxation of symmetric Gauss-Seidel. Of 0.8, 1, 1.2, 1.4 and 1.6 on the first 40 steps of
 * the paper's scenes, 1.2 and 1.4 take the fewest iterations: 6 to 19 % fewer than 1. */
static const double relaxation = 1.3;

int factored_init(factored *f, const block_matrix *A, preconditioner_kind kind) {
    assert(A->row_count >= 0 && A->block_count >= A->row_count);
    const size_t rows = (size_t)A->row_count + 1, blocks = (size_t)A->block_count + 1;
    *f = (factored){0};
    f->diagonal = arrays_add(&f->own, rows, sizeof *f->diagonal);
    f->upper = arrays_add(&f->own, blocks, sizeof *f->upper);
    f->root = arrays_add(&f->own, rows, sizeof *f->root);
    if (kind == PRECONDITIONER_INCOMPLETE_CHOLESKY)
        f->factor = arrays_add(&f->own, blocks, sizeof *f->factor);
    if (!f->own.failed)
        return 0;
    factored_free(f);
    return -1;
}

void factored_free(factored *f) {
    arrays_free(&f->own);
    *f = (factored){0};
}

/* from -= left' right */
static void subtract_product(const double left[3][3], const double right[3][3], double from[3][3]) {
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++)
            from[r][c] -=
                left[0][r] * right[0][c] + left[1][r] * right[1][c] + left[2][r] * right[2][c];
}

/* Computes inverse = C^-1 with a = C C'. Returns 0, and no inverse, unless every pivot is greater
 * than its entry of `least`. */
static int invert_root(const double a[3][3], const double least[3], double inverse[3][3]) {
    const double p0 = a[0][0];
    const double c00 = sqrt(p0), c10 = a[1][0] / c00, c20 = a[2][0] / c00;
    const double p1 = a[1][1] - c10 * c10;
    const double c11 = sqrt(p1), c21 = (a[2][1] - c20 * c10) / c11;
    const double p2 = a[2][2] - c20 * c20 - c21 * c21;
    const double c22 = sqrt(p2);
    if (!(p0 > least[0] && p1 > least[1] && p2 > least[2] && isfinite(p0 + p1 + p2)))
        return 0;
    memset(inverse, 0, sizeof(double[3][3]));
    inverse[0][0] = 1 / c00;
    inverse[1][1] = 1 / c11;
    inverse[2][2] = 1 / c22;
    inverse[1][0] = -c10 * inverse[0][0] * inverse[1][1];
    inverse[2][1] = -c21 * inverse[1][1] * inverse[2][2];
    inverse[2][0] = -(c20 * inverse[0][0] + c21 * inverse[1][0]) * inverse[2][2];
    return 1;
}

/* C^-1 of a block, or 0 if the block is not positive definite: its vertex then keeps the guess. */
static void root_of(const double block[3][3], double root[3][3]) {
    const double none[3] = {0, 0, 0};
    if (!invert_root(block, none, root))
        memset(root, 0, sizeof(double[3][3]));
}

/* Like root_of, but a block that is not positive definite gives a multiple of the identity, so that
 * conjugate gradients detect that A is not positive definite. (No force makes such a block.) A
 * block of 0 gives 0. */
static void root_or_identity(const double block[3][3], double root[3][3]) {
    const double size = fabs(block[0][0]) + fabs(block[1][1]) + fabs(block[2][2]);
    root_of(block, root);
    if (root[0][0] == 0 && size > 0)
        root[0][0] = root[1][1] = root[2][2] = 1 / sqrt(size);
}

void gauss_seidel_root(const double block[3][3], double root[3][3]) {
    root_or_identity(block, root);
    for (int r = 0; r < 3; r++)
        for (int c = 0; c <= r; c++)
            root[r][c] *= sqrt(relaxation);
}

/* Every preconditioner but incomplete Cholesky takes C from A's diagonal. */
static void diagonal_roots(factored *f, const block_matrix *A, preconditioner_kind kind) {
    assert(kind != PRECONDITIONER_INCOMPLETE_CHOLESKY);
    double mean = 0;
    for (int i = 0; i < A->row_count; i++)
        for (int a = 0; a < 3; a++)
            mean += A->value[A->row_start[i]][a][a] / (3.0 * A->row_count);
    for (int i = 0; i < A->row_count; i++) {
        const double(*block)[3] = (const double(*)[3])f->upper[A->row_start[i]];
        double kept[3][3] = {{0}};
        for (int a = 0; a < 3; a++)
            kept[a][a] = kind == PRECONDITIONER_NONE ? mean : block[a][a];
        if (kind == PRECONDITIONER_NONE || kind == PRECONDITIONER_JACOBI)
            root_or_identity((const double(*)[3])kept, f->root[i]);
        else if (kind == PRECONDITIONER_GAUSS_SEIDEL)
            gauss_seidel_root(block, f->root[i]);
        else
            root_or_identity(block, f->root[i]);
    }
}

/* Computes C^-1 of row i's reduced diagonal block. Returns 0, or -1 on breakdown. */
static int reduced_root(factored *f, const block_matrix *A, int i) {
    double least[3], left[3][3];
    const double(*whole)[3] = (const double(*)[3])f->upper[A->row_start[i]];
    memcpy(left, f->factor[A->row_start[i]], sizeof left);
    for (int c = 0; c < 3; c++)
        least[c] = least_pivot * whole[c][c];
    if (invert_root((const double(*)[3])left, least, f->root[i]))
        return 0;
    root_of(whole, f->root[i]);
    /* A vertex whose own block is singular keeps the guess, as with the other preconditioners. */
    return f->root[i][0][0] == 0 ? 0 : -1;
}

/* Subtracts G' G from the blocks of later rows. G are row i's blocks, multiplied by C^-1 from the
 * left. */
static void eliminate(factored *f, const block_matrix *A, int i) {
    const int first = A->row_start[i] + 1, end = A->row_start[i + 1];
    assert(first <= end &&
           A->column[first - 1] == i); /* the diagonal is the first block of a row */
    for (int k = first; k < end; k++) {
        double g[3][3];
        matrix3_multiply((const double(*)[3])f->root[i], (const double(*)[3])f->factor[k], g);
        memcpy(f->factor[k], g, sizeof g);
    }
    for (int k = first; k < end; k++) {
        assert(A->column[k] > i && A->column[k] < A->row_count);
        const int row = A->column[k], row_end = A->row_start[row + 1];
        int at = A->row_start[row];
        for (int m = k; m < end; m++) {
            while (at < row_end && A->column[at] < A->column[m])
                at++;
            if (at < row_end && A->column[at] == A->column[m])
                subtract_product((const double(*)[3])f->factor[k], (const double(*)[3])f->factor[m],
                                 f->factor[at]);
        }
    }
}

/* Computes R from the filtered blocks in `upper`, with diagonal blocks multiplied by 1 + shift.
 * Returns 0, or -1 on breakdown. */
static int factorise(factored *f, const block_matrix *A) {
    assert(f->factor && f->shift > 0);
    memcpy(f->factor, f->upper, sizeof *f->factor * (size_t)A->block_count);
    for (int i = 0; i < A->row_count; i++)
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++)
                f->factor[A->row_start[i]][r][c] *= 1 + f->shift;
    for (int i = 0; i < A->row_count; i++) {
        if (reduced_root(f, A, i) != 0)
            return -1;
        eliminate(f, A, i);
    }
    return 0;
}

/* Replaces block by block C^-T, also multiplied by C^-1 from the left if `both`. */
static void scale_block(const double left_root[3][3], const double right_root[3][3], int both,
                        double block[3][3]) {
    double half[3][3];
    if (both)
        matrix3_multiply(left_root, (const double(*)[3])block, half);
    else
        memcpy(half, block, sizeof half);
    matrix3_multiply_transposed((const double(*)[3])half, right_root, block);
}

static void scale(factored *f, const block_matrix *A, double diagonal_shift) {
    for (int i = 0; i < A->row_count; i++) {
        const double(*root)[3] = (const double(*)[3])f->root[i];
        double(*block)[3] = f->upper[A->row_start[i]];
        scale_block(root, root, 1, block);
        for (int r = 0, m = 0; r < 3; r++)
            for (int c = r; c < 3; c++, m++)
                f->diagonal[i][m] = (block[r][c] + block[c][r]) / 2 - (r == c ? diagonal_shift : 0);
        for (int k = A->row_start[i] + 1; k < A->row_start[i + 1]; k++) {
            const double(*other)[3] = (const double(*)[3])f->root[A->column[k]];
            scale_block(root, other, 1, f->upper[k]);
            if (f->factor)
                scale_block(root, other, 0, f->factor[k]);
        }
    }
}

void factored_build(factored *f, const block_matrix *A, const constraints *c,
                    preconditioner_kind kind) {
    assert((kind == PRECONDITIONER_INCOMPLETE_CHOLESKY) == (f->factor != NULL));
    for (int i = 0; i < A->row_count; i++)
        for (int k = A->row_start[i]; k < A->row_start[i + 1]; k++)
            prefiltered_block(A, c, i, k, f->upper[k]);
    if (kind == PRECONDITIONER_INCOMPLETE_CHOLESKY) {
        /* With a shift of about 1e6 only non-finite values can cause a breakdown. */
        for (f->shift = first_shift; factorise(f, A) != 0 && f->shift < 1e6;)
            f->shift *= 2;
    } else
        diagonal_roots(f, A, kind);
    scale(f, A, kind == PRECONDITIONER_GAUSS_SEIDEL ? 2 : 0);
}
