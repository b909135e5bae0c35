/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Rows that a body updates in place of the arrays' own (redcc_row of redcc/parallel.h). */
#ifndef REDCC_ROWS_H
#define REDCC_ROWS_H

#include "redcc/structures.h"

struct redcc_kept_row;

/** Sets `bytes` bytes to neutral elements of the array's operator; of a type that has none, to 0.
 */
void redcc_rows_fill(const redcc_array *array, void *values, redcc_size bytes);

/** Brings rows into their arrays, one after the other, where the thread owns them: each under its
 *  lock, or as one contribution to compensated sums. */
void redcc_rows_settle(redcc_worker *worker, const struct redcc_kept_row *kept, int count);

#endif
