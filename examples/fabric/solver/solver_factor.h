/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Preconditioners M that approximate A, and the preconditioned matrix.
 *  - none: M = the mean diagonal times I
 *  - Jacobi: M = A's diagonal
 *  - block-Jacobi: M = A's diagonal blocks, 3x3
 *  - symmetric Gauss-Seidel: M = (D + L) D^-1 (D + L)'. L are the blocks below A's diagonal, D its
 *    diagonal blocks divided by a relaxation factor, 1.3. In double it is replaced by
 *    solver_domains.c.
 *  - incomplete Cholesky, IC(0): M = R'R. R has the sparsity pattern of A's blocks, and M = A on
 *    that pattern (Meijerink and van der Vorst 1977). Cloth's matrices are not M-matrices, so
 *    dropped fill-in may leave a block indefinite; then A with enlarged diagonal blocks is factored
 *    instead (Manteuffel 1980).
 * With constraints, A is replaced by S A S + s (I - S): prefiltered_block.
 */
#ifndef FABRIC_SOLVER_FACTOR_H
#define FABRIC_SOLVER_FACTOR_H

#include "solver.h"
#include "system/constraint.h"
#include "system/system.h"

/** The scaled matrices C^-1 A C^-T = D^ + U + U' and R C^-T = I + F. C C' are M's diagonal blocks;
 *  for incomplete Cholesky, C' are R's diagonal blocks. */
typedef struct factored {
    double (*diagonal)[6];  /* [rows] D^, for Gauss-Seidel D^ - 2 I: xx xy xz yy yz zz */
    double (*upper)[3][3];  /* [blocks] U; entries of diagonal blocks are unused */
    double (*factor)[3][3]; /* [blocks] F; NULL unless incomplete Cholesky */
    double (*root)[3][3];   /* [rows] C^-1, lower triangles */
    double shift;           /* incomplete Cholesky: diagonal blocks are multiplied by 1 + shift */
    arrays own;
} factored;

/** Allocates f for matrices with A's sparsity pattern. Returns 0, or -1 if out of memory. */
int factored_init(factored *f, const block_matrix *A, preconditioner_kind kind);
void factored_free(factored *f);

/** Computes f for A and the constraints c. Sequential: the factorisations are recurrences from row
 *  to row. */
void factored_build(factored *f, const block_matrix *A, const constraints *c,
                    preconditioner_kind kind);

/** Computes Gauss-Seidel's C^-1 for a diagonal block: C C' is the block divided by the relaxation
 *  factor. A block that is not positive definite gives a multiple of the identity. A block of 0
 *  gives 0: its vertex keeps the initial guess. */
void gauss_seidel_root(const double block[3][3], double root[3][3]);

#endif
