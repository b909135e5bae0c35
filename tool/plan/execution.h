/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Properties of a loop that decide whether the runtime may keep a plan, copy arrays, skip
 *  iterations. */
#ifndef PLAN_EXECUTION_H
#define PLAN_EXECUTION_H

#include "plan/plan.h"

/** How a key's value is stored in words of 64 bits; KEY_UNFIT: no plan is kept. */
typedef enum key_form { KEY_INTEGER, KEY_POINTER, KEY_BYTES, KEY_UNFIT } key_form;
key_form form_of_key(const ir_type *type);

/** May the runtime update private copies of the array? Copies hold adjacent elements, so not if
 *  other data lie between them; nor if updates of copies could not be merged. */
bool may_be_copied(const loop_plan *plan, const reduction_array *array);

/** Sets execution; has_ready_base is set. */
void plan_execution(loop_plan *plan);

#endif
