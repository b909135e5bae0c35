/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Where another pointer of the same name may stand for an array in a copy of the body. */
#ifndef PLAN_STAND_IN_H
#define PLAN_STAND_IN_H

#include "plan/plan.h"

/** May a pointer stand for this array in the body? Not where its type or its size may be asked. */
bool can_be_pointer(const loop_plan *plan, const ir_variable *variable);
/** The same of the base of a reduction array, which may be a pointer already. */
bool can_be_shadowed(const loop_plan *plan, const ir_node *base);
/** Is a macro used in the body? */
bool has_macro(const loop_plan *plan);

#endif
