/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds counters that are set before their loop and stepped by its body. Only must_write_repeat.c
 *  uses this header. */
#ifndef ANALYSIS_MUST_WRITE_WALK_H
#define ANALYSIS_MUST_WRITE_WALK_H

#include "ir/ir.h"

/** The value that the variable has when control reaches the loop. The statement that sets it last
 *  must be an earlier one in the same block, executed whenever the loop is. *number becomes its
 *  index in the block. NULL if the value is unknown. */
const ir_node *start_before(const ir_node *loop, const ir_variable *variable, unsigned *number);

/** The only write of the variable in the body. It must be a step by a constant that each iteration
 *  executes once, and the iteration must not use the variable after it. Otherwise NULL. */
const ir_node *step_of_body(const ir_node *body, const ir_variable *variable);

#endif
