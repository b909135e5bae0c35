/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Decides what may be executed in a branch that the program does not take. */
#ifndef PLAN_BRANCH_H
#define PLAN_BRANCH_H

#include "plan/plan.h"

/** Does the variable carry no value into the branch of an `if`, nor out of it, within the loop?
 * Then its values in the branch do not depend on the condition. */
bool is_only_of_branch(const loop_facts *facts, const ir_node *branch, const ir_variable *variable);

/** Does the inner loop terminate, even when it is executed where the program would not? True only
 * if its header shows it: the counter approaches a bound that consists of constants and of
 * variables that the outer loop only reads. */
bool ends_in_any_case(const loop_facts *facts, const ir_node *loop);

#endif
