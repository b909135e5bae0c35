/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Is a variable assigned before it is read, in each execution of a statement? */
#ifndef PLAN_FRESH_H
#define PLAN_FRESH_H

#include "ir/ir.h"

/** Returns true if, on each path through the statement, each read of the variable or of a part of
 * it comes after an assignment of that variable or part in the same execution. Returns false if
 * the text does not show this. The statement must not contain labels. */
bool is_fresh_in(const ir_node *statement, const ir_variable *variable);

#endif
