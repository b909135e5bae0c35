/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Computes how far a row's address advances when a counter advances by 1. A row is here the lvalue
 *  that is accessed, such as a[i].x. */
#ifndef ANALYSIS_ROW_STEPS_H
#define ANALYSIS_ROW_STEPS_H

#include "analysis/base/facts.h"

/** The distance in bytes from the row to the row for the counter's next value; at least the row's
 *  own size. 0 if the row does not depend on the counter. -1 if the distance is unknown or not
 *  constant. */
int64_t row_stride(const ir_node *row, const ir_variable *counter);

/** Is the row independent of the counter, or is row_stride positive? */
bool row_steps_with(const ir_node *row, const ir_variable *counter);

/** Is it an integer type that cannot wrap around, or one that wraps around as addresses do (8
 *  bytes)? */
bool row_index_is_steady(const ir_type *type);

/** Does converting an integer of type `from` to `to` preserve the difference of two values? True
 *  only if row_index_is_steady(to). */
bool row_index_keeps_steps(const ir_type *from, const ir_type *to);

/** Does the loop access elements at a constant distance, so that its first and its last iteration
 *  determine the range? */
bool source_loop_is_span(const source_loop *loop, const ir_node *row);

/** Do both sources read the same rows, in loops with the same bounds? */
bool source_rows_equal(const loop_source *a, const loop_source *b);

#endif
