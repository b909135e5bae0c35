/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Properties of a loop that decide whether the runtime may keep a plan (docs/glossary.md), copy
 * arrays, or skip iterations. */
#ifndef PLAN_EXECUTION_H
#define PLAN_EXECUTION_H

#include "plan/plan.h"

/** How the value of a key is stored in 64-bit words. KEY_UNFIT: the value cannot be stored, so no
 * plan is kept. */
typedef enum key_form { KEY_INTEGER, KEY_POINTER, KEY_BYTES, KEY_UNFIT } key_form;
key_form form_of_key(const ir_type *type);

/** May the runtime update private copies of the array? False if other data lie between the array's
 *  elements, because copies hold adjacent elements; if the updates do not commute; or if a
 *  sanitizer would report overflows of partial sums. */
bool may_be_copied(const loop_plan *plan, const reduction_array *array);

/** May the updates be made in another order, if OpenMP's directives leave it open? Then each
 *  iteration must still be executed once, and the operands of scalars are stored. */
bool may_be_reordered(const loop_facts *facts);

/** Sets plan->execution. Requires has_ready_base. */
void plan_execution(loop_plan *plan);

#endif
