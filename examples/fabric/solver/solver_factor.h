/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Preconditioners, and the matrix as they make it. M = E E' stands for A in
 *     none                   M = the mean diagonal times I
 *     Jacobi                 M = A's diagonal
 *     block-Jacobi           M = A's diagonal blocks, 3x3
 *     symmetric Gauss-Seidel M = (D + L) D^-1 (D + L)', L the blocks below A's diagonal and D its
 *                            diagonal blocks over a relaxation, 1.3; in double by solver_domains.c
 *     incomplete Cholesky    M = R'R, R with A's blocks as pattern and M = A on it: IC(0)
 *                            (Meijerink and van der Vorst 1977). Cloth's matrices are no
 * M-matrices, so fill that is dropped may leave a block indefinite: then A with its diagonal blocks
 * enlarged is factored instead (Manteuffel 1980).
 * Within constraints A is replaced by S A S + s (I - S): prefiltered_block.
 */
#ifndef FABRIC_SOLVER_FACTOR_H
#define FABRIC_SOLVER_FACTOR_H

#include "solver.h"
#include "system/constraint.h"
#include "system/system.h"

/** Scaled by C^-1 from the left and C^-T from the right, C C' being M's diagonal blocks: A becomes
 *  D^ + U + U', and R becomes I + F. */
typedef struct factored {
    double (*diagonal)[6];  /* [rows] D^, of Gauss-Seidel D^ - 2 I: xx xy xz yy yz zz */
    double (*upper)[3][3];  /* [blocks] U; the places of diagonal blocks are unused */
    double (*factor)[3][3]; /* [blocks] F; NULL but for incomplete Cholesky */
    double (*root)[3][3];   /* [rows] C^-1, lower triangles; 0 where a block is not positive */
    double shift;           /* of incomplete Cholesky: diagonal blocks counted 1 + shift times */
    arrays own;
} factored;

/** For the layout of A. 0, or -1: out of memory. */
int factored_init(factored *f, const block_matrix *A, preconditioner_kind kind);
void factored_free(factored *f);

/** Sequential: the factorisations are recurrences from row to row. */
void factored_build(factored *f, const block_matrix *A, const constraints *c,
                    preconditioner_kind kind);

/** C^-1 of Gauss-Seidel for a diagonal block: C C' is the block over the relaxation. A
 *  multiple of the identity where that is not positive, but 0 of 0: the vertex keeps the guess. */
void gauss_seidel_root(const double block[3][3], double root[3][3]);

#endif
