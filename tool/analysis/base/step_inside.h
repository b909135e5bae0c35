/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Handles variables that are stepped inside an expression: `h[*p++]` reads the same element as
 *  `h[*p]` evaluated at the beginning of its statement. */
#ifndef ANALYSIS_STEP_INSIDE_H
#define ANALYSIS_STEP_INSIDE_H

#include "ir/ir.h"

/** Is the node v++ or v-- with a variable v? */
bool is_step_afterwards(const ir_node *node);

/** The only write of the variable in `body`, if it is a v++ or v-- whose value is used. It must be
 *  executed exactly once in each execution of the body, jumps aside, and the body must not name the
 *  variable after it. Otherwise NULL. */
const ir_node *lone_last_step(const ir_node *body, const ir_variable *variable);

/** May a `continue` in the body skip the step? The step is one that lone_last_step finds. */
bool may_continue_before(const ir_node *body, const ir_node *step);

/** A copy of the lvalue, without a parent, in which v replaces each v++ and v--. Returns the lvalue
 *  itself if it has no such steps, or if its statement names one of these variables elsewhere
 *  too. */
const ir_node *lvalue_before_steps(arena *a, const ir_node *lvalue);

#endif
