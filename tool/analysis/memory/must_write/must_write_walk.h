/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Counters that are set before their loop, and stepped by its body. For must_write_repeat.c. */
#ifndef ANALYSIS_MUST_WRITE_WALK_H
#define ANALYSIS_MUST_WRITE_WALK_H

#include "ir/ir.h"

/** The value that the variable has when control reaches the loop: a statement before it in the same
 *  block, which is executed whenever the loop is, sets it last. *number: this statement's number in
 *  the block. NULL: unknown. */
const ir_node *start_before(const ir_node *loop, const ir_variable *variable, unsigned *number);

/** The only write of the variable in the body: a step by a constant, executed once in each
 *  iteration, and the iteration does not use the variable after it. NULL: none. */
const ir_node *step_of_body(const ir_node *body, const ir_variable *variable);

#endif
