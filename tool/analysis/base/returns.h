/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Removes the `return` statements from a function's body that replaces a call. */
#ifndef ANALYSIS_RETURNS_H
#define ANALYSIS_RETURNS_H

#include "ir/ir.h"

/** Can all `return` statements be removed? That requires that none is in a loop or a `switch`, and
 *  that each branch of an `if` with statements after it either always returns or never does. */
bool returns_are_structured(const ir_node *body);

/** Removes the `return` statements from a copy of such a body. The statements after a conditional
 *  `return` become the `if` statement's other branch. In place of each `return` its value is
 *  assigned to `result`, unless that is NULL. */
void returns_take_out(arena *a, ir_node *body, ir_variable *result);

#endif
