/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds calls that their functions' bodies can replace (expanded_call.h). */
#ifndef ANALYSIS_EXPANDABLE_CALL_H
#define ANALYSIS_EXPANDABLE_CALL_H

#include "ir/ir.h"

/** The call in the statement if its arguments assign nothing, and if the function's body can
 * replace the call; NULL otherwise. The body of a function of another file may only name what this
 * file declares, and may contain a single addition of floating-point numbers, but no other
 * operation on them. A body must not contain labels, opaque parts, directives, attributes, static
 * variables, a `return` in a loop, or names of the file that mean something else in the caller. The
 * result type must not be const. The caller must make sure that functions called in the arguments
 * change nothing, because the block evaluates the arguments in their order. */
ir_node *expandable_call_of(const ir_unit *unit, const ir_function *caller,
                            const ir_node *statement);

/** The call in a statement `f(...);`, or in `x = ...;` with a variable x, `int x = ...;` or
 * `if (...)`, where the value or condition contains one call, and otherwise only numbers and own
 * scalars. NULL if the statement has another form. */
ir_node *call_in_statement(const ir_node *statement);

/** Is the expression an own scalar: an automatic scalar variable whose address is not taken, so
 * that no called function can change it? */
bool is_own_scalar(const ir_node *node);
/** Does anything below the node take the variable's address by &? */
bool takes_address_of(const ir_node *node, const ir_variable *variable);

#endif
