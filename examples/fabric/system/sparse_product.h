/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The product of a matrix of 3x3 blocks with a vector. */
#ifndef FABRIC_SPARSE_PRODUCT_H
#define FABRIC_SPARSE_PRODUCT_H

#include "system.h"

/** y += A x for a symmetric A given by its half. x, y [A->row_count] must not overlap. */
void half_product(const block_matrix *A, const double (*x)[3], double (*y)[3]);

#endif
