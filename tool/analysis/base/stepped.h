/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Loops that go up by 1, what else they step, and rows that lie one after the other in them. */
#ifndef ANALYSIS_STEPPED_H
#define ANALYSIS_STEPPED_H

#include "analysis/base/facts.h"

/** Is this a `for` that goes up by 1, whatever its body does? Then *span has what it steps. */
bool span_recognise(ir_node *loop, loop_span *span);

/** How many of the variables that the loop steps the expression mentions. */
unsigned span_mentions(const loop_span *span, const ir_node *expression);

/** The one that it mentions; NULL: none, or several. */
const ir_variable *span_stepped_in(const loop_span *span, const ir_node *expression);

/** Does the row stay the same in the loop, or go on to the next element in each iteration? */
bool span_is_told(const loop_span *span, const ir_node *row);

#endif
