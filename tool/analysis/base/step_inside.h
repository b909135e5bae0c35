/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Variables that an expression steps on its way: `h[*p++]` is `h[*p]` where its statement begins.
 */
#ifndef ANALYSIS_STEP_INSIDE_H
#define ANALYSIS_STEP_INSIDE_H

#include "ir/ir.h"

/** Is it v++ or v--, of a variable? */
bool is_step_afterwards(const ir_node *node);

/** The one write of the variable in `body`: a step afterwards whose value is used, that is executed
 *  once whenever the body is, but for jumps, and behind which the body does not name the variable.
 *  NULL: there is none. */
const ir_node *lone_last_step(const ir_node *body, const ir_variable *variable);

/** The lvalue with v in place of each v++ and v--, a copy without a parent, where its statement
 *  names each such variable no other time; else, and where there are none, the lvalue itself. */
const ir_node *lvalue_before_steps(arena *a, const ir_node *lvalue);

#endif
