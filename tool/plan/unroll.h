/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Which short loops inside a body the compiler is to unroll. */
#ifndef PLAN_UNROLL_H
#define PLAN_UNROLL_H

#include "plan/plan.h"

/** May the `for`, of few iterations, be unrolled in text that computes for several iterations at
 * once; around updates there; in the body for one iteration? By the size of what comes out. */
bool is_unrolled_computation(const ir_node *loop);
bool is_unrolled_lane_update(const ir_node *loop);
bool is_unrolled_in_body(const ir_node *loop);
/** May a pragma stand in front of a `for` of the user's text? Not if there is a pragma, attribute
 * or label there. */
bool takes_pragma(const loop_plan *plan, const ir_node *node);

#endif
