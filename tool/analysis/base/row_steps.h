/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The distance between the rows of consecutive values of a counter. */
#ifndef ANALYSIS_ROW_STEPS_H
#define ANALYSIS_ROW_STEPS_H

#include "analysis/base/facts.h"

/** Bytes from the row to the one for the counter's next value: at least the row's own size. 0: the
 *  row is independent of the counter. -1: the distance is unknown, or not constant. */
int64_t row_stride(const ir_node *row, const ir_variable *counter);

/** Is the row independent of the counter, or is row_stride positive? */
bool row_steps_with(const ir_node *row, const ir_variable *counter);

/** Is it an integer type whose values never wrap around, or do as addresses do? */
bool row_index_is_steady(const ir_type *type);

/** Does converting an integer to this steady type preserve the distance between two values? */
bool row_index_keeps_steps(const ir_type *from, const ir_type *to);

/** Does the loop access elements at constant distances, so that the first and the last determine
 * the range? */
bool source_loop_is_span(const source_loop *loop, const ir_node *row);

/** Do both denote the same rows, in loops with the same bounds? */
bool source_rows_equal(const loop_source *a, const loop_source *b);

#endif
