/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Elements one after the other, as a counter is incremented. */
#ifndef ANALYSIS_ROW_STEPS_H
#define ANALYSIS_ROW_STEPS_H

#include "analysis/base/facts.h"

/** Bytes from the row to that of the counter's next value, at least those of the row; 0: it is
 *  independent of the counter; -1: they are not known, or differ. */
int64_t row_stride(const ir_node *row, const ir_variable *counter);

/** Is the row independent of the counter, or a later one of an array for its next value, at a
 *  constant distance? */
bool row_steps_with(const ir_node *row, const ir_variable *counter);

/** Does the loop access elements at constant distances, so that the first and the last determine
 * the range? */
bool source_loop_is_span(const source_loop *loop, const ir_node *row);

/** Do both denote the same rows, in loops with the same bounds? */
bool source_rows_equal(const loop_source *a, const loop_source *b);

#endif
