/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Consecutive elements, as a counter is incremented. */
#ifndef ANALYSIS_ROW_STEPS_H
#define ANALYSIS_ROW_STEPS_H

#include "analysis/base/facts.h"

/** Is the row independent of the counter, or the next element of an array for its next value? */
bool row_steps_with(const ir_node *row, const ir_variable *counter);

/** Does the loop access consecutive elements, so that the first and the last determine the
 *  range? */
bool source_loop_is_span(const source_loop *loop, const ir_node *row);

/** Do both denote the same rows, in loops with the same bounds? */
bool source_rows_equal(const loop_source *a, const loop_source *b);

#endif
