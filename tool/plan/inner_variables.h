/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Variables declared outside of an inner loop that carry no value from one of its iterations to
 * the next. */
#ifndef PLAN_INNER_VARIABLES_H
#define PLAN_INNER_VARIABLES_H

#include "ir/ir.h"

/** Is the variable's value dead at the end of each iteration of `inner`? It is if, before each read
 *  in `body` (the body of the outer loop), a statement sets the variable and no iteration of
 *  `inner` ends in between. The variable's address must never be taken. */
bool inner_value_is_dead(const ir_node *body, const ir_node *inner, const ir_variable *variable);

/** Is the statement a plain assignment of the variable, or its declaration with a value? */
bool inner_statement_sets(const ir_node *statement, const ir_variable *variable);

#endif
