/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Which short loops inside a body the compiler is to unroll. */
#ifndef EMIT_UNROLL_H
#define EMIT_UNROLL_H

#include "emit/loop.h"

/** unroll.c: what stands in front of a `for` of few iterations, which the compiler is to unroll, in
 * text that computes; of others "". */
const char *unrolled_computation(const ir_node *loop);
/** The same around updates of lanes, which their text for guarded iterations leaves rolled. */
const char *unrolled_lane_updates(const ir_node *loop);
/** The same in the body for one iteration. */
const char *unrolled_in_body(const ir_node *loop);
/** May that stand in front of a `for` of the user's text? Not beside a pragma, attribute or label.
 */
bool takes_pragma(const loop_text *loop, const ir_node *node);

#endif
