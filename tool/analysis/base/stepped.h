/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Recognises spans (loop_span in facts.h): inner loops with a small step, together with the
 *  variables that they step. */
#ifndef ANALYSIS_STEPPED_H
#define ANALYSIS_STEPPED_H

#include "analysis/base/facts.h"

/** Is this an ascending `for` with a small step? The body may be anything. If so, *span has the
 *  variables that are stepped with the counter, and those that the header changes in another
 *  way. */
bool span_recognise(ir_node *loop, loop_span *span);

/** How many of the loop's stepped variables the expression mentions. */
unsigned span_mentions(const loop_span *span, const ir_node *expression);

/** The only stepped variable that the expression mentions; NULL if it mentions none or several. */
const ir_variable *span_stepped_in(const loop_span *span, const ir_node *expression);

/** Is the row invariant in the loop, or at a constant distance from the row of the preceding
 *  iteration? */
bool span_is_recorded(const loop_span *span, const ir_node *row);

#endif
