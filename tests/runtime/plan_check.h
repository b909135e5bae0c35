/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef PLAN_CHECK_H
#define PLAN_CHECK_H

#include "plan/plan.h"
#include "problem.h"

/** Fails the test where the plan is not one for the problem: every iteration that updates something
 *  is executed once, or, with owners that guard their writes, once by each owner of what it writes;
 *  no element has two owners. */
void check_plan(const struct problem *problem, const struct plan *plan);

#endif
