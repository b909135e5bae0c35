/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Textbook methods with whole (dense) matrices, for comparison. */
#ifndef FABRIC_TEST_DENSE_H
#define FABRIC_TEST_DENSE_H

#include "system/system.h"

/** Returns the half-stored matrix as [n * n], n = 3 rows. The caller frees it. */
double *dense_of(const block_matrix *half);

/** Computes the Cholesky factor in place. Returns 0 if A is positive definite, or else 1 + the
 * number of the row where the method fails. */
int dense_cholesky(double *a, int n);

/** Computes x = A^-1 b by elimination with column pivoting; A is destroyed. */
void dense_solve(double *a, int n, double *x, const double *b);

#endif
