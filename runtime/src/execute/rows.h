/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Scratch rows that a body updates instead of the arrays' rows (redcc_row of redcc/parallel.h). */
#ifndef REDCC_ROWS_H
#define REDCC_ROWS_H

#include "redcc/structures.h"

struct redcc_kept_row;

/** Sets `bytes` bytes to neutral elements of the array's operator. If the type has no neutral
 * element, sets them to 0. */
void redcc_rows_fill(const redcc_array *array, void *values, redcc_size bytes);

/** Adds the rows in `kept` to their arrays in order, if the thread owns them: each under its lock,
 * or as one contribution to compensated sums. */
void redcc_rows_settle(redcc_worker *worker, const struct redcc_kept_row *kept, int count);

#endif
