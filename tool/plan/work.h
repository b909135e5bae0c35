/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Estimates the work of an iteration in floating-point operations. A division, or a call with a
 *  floating result, counts as 8. A call also counts the operations of the called function's
 *  body. */
#ifndef PLAN_WORK_H
#define PLAN_WORK_H

#include "plan/plan.h"

/** With this many operations, an iteration takes longer than loading its rows from the caches, and
 *  computing several iterations at once (lanes.h) pays. Measured by script/bench lanes: cloth,
 *  membrane, triangle, hinge and drag gained; springs, contacts and Lennard-Jones, which are all
 *  below this number, did not. */
enum { WORK_HEAVY = 150 };

/** With this many operations, an iteration makes many updates, or takes as long (REDCC_LONG). */
enum { WORK_LONG = 512 };

/** Operations of an iteration; counting stops at 10000. */
int64_t work_of_iteration(const loop_plan *plan);

/** Operations of a statement of the iteration. */
int64_t work_of_statement(const loop_plan *plan, const ir_node *statement);

/** Returns the statement's work outside of its updates: the number of nodes of expressions, times
 *  their executions, including called functions. */
int64_t work_outside_updates(const loop_plan *plan, const ir_node *statement);

/** The trip count of a loop with constant bounds: 3 for `for (c = 0; c < 3; c++)`. Returns 0 if it
 * is unknown or above 10000. */
int64_t work_constant_trip(const ir_node *loop);

#endif
