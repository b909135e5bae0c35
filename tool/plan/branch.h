/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What may be executed in a branch although the program does not take it. */
#ifndef PLAN_BRANCH_H
#define PLAN_BRANCH_H

#include "plan/plan.h"

/** Does the variable, in an iteration, pass no value into the branch of an `if`, nor out of it?
 * Then it has the same values there whatever decides whether the branch is executed. */
bool is_only_of_branch(const loop_facts *facts, const ir_node *branch, const ir_variable *variable);

/** Does the inner loop end, even if the program would not execute it here? True only if the text
 *  shows it: the counter approaches a bound that consists of constants and of variables that the
 *  outer loop only reads. */
bool ends_in_any_case(const loop_facts *facts, const ir_node *loop);

#endif
