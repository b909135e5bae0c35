/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Is a variable assigned before it is read, in each execution of a statement? */
#ifndef PLAN_FRESH_H
#define PLAN_FRESH_H

#include "ir/ir.h"

/** Does, on each path through the statement, an assignment of the variable, or of a part of it,
 * precede each read of that variable or part in the same execution? False if the text does not show
 * it. Requires a statement without labels. */
bool is_fresh_in(const ir_node *statement, const ir_variable *variable);

#endif
