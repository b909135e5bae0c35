/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Variables declared outside of an inner loop that serve each of its iterations alone. */
#ifndef PLAN_INNER_VARIABLES_H
#define PLAN_INNER_VARIABLES_H

#include "ir/ir.h"

/** Is each read of the variable in `body`, the analysed loop's, preceded by a statement that sets
 *  it, with no iteration of `inner` ending in between? Then nothing depends on the value that an
 *  iteration of `inner` leaves, whether all of it was executed or not. The variable's address is
 *  never taken. */
bool inner_value_is_spent(const ir_node *body, const ir_node *inner, const ir_variable *variable);

/** Does executing this statement always give the variable a value? */
bool inner_statement_sets(const ir_node *statement, const ir_variable *variable);

#endif
