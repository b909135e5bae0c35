/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Scratch rows that a body updates instead of the arrays' rows (redcc_row of redcc/parallel.h). */
#ifndef REDCC_ROWS_H
#define REDCC_ROWS_H

#include "redcc/structures.h"

struct redcc_kept_row;

/** Sets `bytes` bytes to neutral elements of the array's operator; to 0 if there is no neutral
 * element for its type. */
void redcc_rows_fill(const redcc_array *array, void *values, redcc_size bytes);

/** Adds those rows in `kept` that the thread owns to their arrays, in order: each under its lock,
 * or as one contribution to compensated sums. */
void redcc_rows_settle(redcc_worker *worker, const struct redcc_kept_row *kept, int count);

#endif
