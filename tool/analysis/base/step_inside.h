/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Variables that an expression steps: `h[*p++]` is `h[*p]` at the beginning of its statement. */
#ifndef ANALYSIS_STEP_INSIDE_H
#define ANALYSIS_STEP_INSIDE_H

#include "ir/ir.h"

/** Is it v++ or v--, of a variable? */
bool is_step_afterwards(const ir_node *node);

/** The only write of the variable in `body`: a v++ or v-- whose value is used. It is executed
 *  once whenever the body is, except after jumps, and the body does not name the variable after it.
 *  NULL: none. */
const ir_node *lone_last_step(const ir_node *body, const ir_variable *variable);

/** A copy, without a parent, of the lvalue with v in place of each v++ and v--, if its statement
 *  names each such variable only there. Otherwise, or if there are none, the lvalue itself. */
const ir_node *lvalue_before_steps(arena *a, const ir_node *lvalue);

#endif
