/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Calls in whose place their functions' bodies can stand (expanded_call.h). */
#ifndef ANALYSIS_EXPANDABLE_CALL_H
#define ANALYSIS_EXPANDABLE_CALL_H

#include "ir/ir.h"

/** The call in the statement, if its arguments assign nothing, and its function has a body in this
 *  file or its headers that can stand in the call's place: without labels, opaque parts,
 * directives, attributes, static variables, a `return` in a loop, or names of the file that mean
 * something else in the caller. NULL: there is none. Functions called in the arguments must not
 * change anything: the arguments are evaluated in their order. */
ir_node *expandable_call_of(const ir_unit *unit, const ir_function *caller,
                            const ir_node *statement);

/** The call that is the statement, or the only one in the value that the statement assigns to an
 * own scalar, among numbers and other own scalars. NULL: the statement has another form. */
ir_node *call_in_statement(const ir_node *statement);

/** Is it a local variable that no function can change? */
bool is_own_scalar(const ir_node *node);
/** Does anything below the node take the variable's address by &? */
bool takes_address_of(const ir_node *node, const ir_variable *variable);

#endif
