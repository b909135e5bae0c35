/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The `return` statements of a function's body that is put in the place of a call. */
#ifndef ANALYSIS_RETURNS_H
#define ANALYSIS_RETURNS_H

#include "ir/ir.h"

/** Can each `return` be removed? None is in a loop or a switch. If statements follow an `if`, each
 *  of its branches always returns, or never. */
bool returns_are_structured(const ir_node *body);

/** Removes them from a copy of such a body: what follows a conditional `return` becomes the other
 *  branch. Each sets `result` to its value (NULL: no value is needed). */
void returns_take_out(arena *a, ir_node *body, ir_variable *result);

#endif
