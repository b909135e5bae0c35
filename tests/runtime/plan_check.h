/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef PLAN_CHECK_H
#define PLAN_CHECK_H

#include "plan/plan.h"
#include "problem.h"

/** Fails the test if the plan is wrong for the problem. Every iteration that updates anything must
 * be executed once or, with owners that check their writes, once by each owner of a written
 * element. No element may have two owners. */
void check_plan(const struct problem *problem, const struct plan *plan);

#endif
