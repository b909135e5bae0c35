/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Dense oracles: whole matrices, by the book. */
#ifndef FABRIC_TEST_DENSE_H
#define FABRIC_TEST_DENSE_H

#include "system/system.h"

/** The half-stored matrix as [n * n], n = 3 rows. The caller frees. */
double *dense_of(const block_matrix *half);

/** Cholesky in place; 0 if A is positive definite, else 1 + the row where it fails. */
int dense_cholesky(double *a, int n);

/** x = A^-1 b by elimination, largest pivot of the column; A is destroyed. */
void dense_solve(double *a, int n, double *x, const double *b);

#endif
