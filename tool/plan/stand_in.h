/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Decides whether a pointer of the same name may replace an array in a copy of the body. */
#ifndef PLAN_STAND_IN_H
#define PLAN_STAND_IN_H

#include "plan/plan.h"

/** May a pointer replace this array in the body? Not if its type or its size may be used. */
bool can_be_pointer(const loop_plan *plan, const ir_variable *variable);
/** May a pointer of the same name replace the base of a reduction array in the body? The base may
 *  already be a pointer. */
bool can_be_shadowed(const loop_plan *plan, const ir_node *base);
/** Does the body use a macro? */
bool has_macro(const loop_plan *plan);

#endif
