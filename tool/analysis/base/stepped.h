/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Loops with a short step, other variables that they step, and rows at equal distances in them. */
#ifndef ANALYSIS_STEPPED_H
#define ANALYSIS_STEPPED_H

#include "analysis/base/facts.h"

/** Is this an ascending `for` with a short step, with any body? Then *span has the variables that
 *  are stepped with its counter, and those that the header changes otherwise. */
bool span_recognise(ir_node *loop, loop_span *span);

/** The number of the loop's stepped variables that the expression mentions. */
unsigned span_mentions(const loop_span *span, const ir_node *expression);

/** The only stepped variable that it mentions; NULL: none, or several. */
const ir_variable *span_stepped_in(const loop_span *span, const ir_node *expression);

/** Is the row invariant in the loop, or at a constant distance from that of the iteration before?
 */
bool span_is_recorded(const loop_span *span, const ir_node *row);

#endif
