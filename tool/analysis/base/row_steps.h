/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Elements that lie one behind the other, as a counter goes up. */
#ifndef ANALYSIS_ROW_STEPS_H
#define ANALYSIS_ROW_STEPS_H

#include "analysis/base/facts.h"

/** Does the row not depend on the counter, or is it the next element of an array for the next value
 *  of it? */
bool row_steps_with(const ir_node *row, const ir_variable *counter);

/** Does the loop come to one element after the other, so that the first and the last say where all
 *  of them are? */
bool source_loop_is_span(const source_loop *loop, const ir_node *row);

/** Loops of the same bounds; their counters may be others. */
bool source_loops_equal(unsigned count, const source_loop *a, unsigned other_count,
                        const source_loop *b);

/** Do both tell the same rows, in loops of the same bounds? */
bool source_rows_equal(const loop_source *a, const loop_source *b);

#endif
