/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Decides which short loops inside a body the compiler should unroll. */
#ifndef PLAN_UNROLL_H
#define PLAN_UNROLL_H

#include "plan/plan.h"

/** Should the compiler unroll the `for`? is_unrolled_computation decides this for vector code,
 * is_unrolled_lane_update for loops around updates in vector code, and is_unrolled_in_body for the
 * body of one iteration. Each decides by the size of the unrolled code. */
bool is_unrolled_computation(const ir_node *loop);
bool is_unrolled_lane_update(const ir_node *loop);
bool is_unrolled_in_body(const ir_node *loop);

/** May a pragma be inserted before the `for`? Not if the `for` is part of a macro's expansion, or
 * if a pragma, attribute or label precedes it. */
bool takes_pragma(const loop_plan *plan, const ir_node *node);

#endif
