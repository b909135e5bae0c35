/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Preconditioning with constraints: block-Jacobi, and the prefiltered blocks from which the other
 *  preconditioners start. */
#ifndef FABRIC_SOLVER_PRECONDITION_H
#define FABRIC_SOLVER_PRECONDITION_H

#include "system/constraint.h"
#include "system/system.h"

/**
 * P_i = S (S A_ii S + s (I - S))^-1 S, any s > 0, with S of constraint.h: the inverse of A's
 * diagonal block on vertex i's free directions, 0 on the others. So search directions satisfy the
 * constraints (as in the prefiltered conjugate gradients of Tamstorf, Jones and McCormick 2015). A
 * block that is not positive definite gives a multiple of S, so that the iteration detects it. (No
 * force makes such a block.) A block of 0 gives P_i = 0: its vertex keeps the guess.
 */
void preconditioner_build(const block_matrix *A, const constraints *c, double (*inverse)[6]);

/** Computes block k of row i of S A S + s (I - S), any s > 0. This matrix replaces A if there are
 *  constraints (Tamstorf, Jones and McCormick 2015). */
void prefiltered_block(const block_matrix *A, const constraints *c, int i, int k, double out[3][3]);

/** out = P_i in */
static inline void precondition(const double inverse[6], const double in[3], double out[3]) {
    out[0] = inverse[0] * in[0] + inverse[1] * in[1] + inverse[2] * in[2];
    out[1] = inverse[1] * in[0] + inverse[3] * in[1] + inverse[4] * in[2];
    out[2] = inverse[2] * in[0] + inverse[4] * in[1] + inverse[5] * in[2];
}

#endif
