/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Decides what may be executed in a branch that the program does not take. */
#ifndef PLAN_BRANCH_H
#define PLAN_BRANCH_H

#include "plan/plan.h"

/** Returns true if, within the loop, the variable carries no value into the branch of an `if` and
 * none out of it. Its values in the branch then do not depend on the condition. */
bool is_only_of_branch(const loop_facts *facts, const ir_node *branch, const ir_variable *variable);

/** Does the inner loop terminate, even when it is executed where the program would not execute it?
 * True only if the loop's header shows this: the counter approaches a bound that consists of
 * constants and of variables that the outer loop only reads. */
bool ends_in_any_case(const loop_facts *facts, const ir_node *loop);

#endif
