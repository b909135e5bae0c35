/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The iterations in which a piece of the loop's body is executed, as far as the counter
 *  decides. */
#ifndef ANALYSIS_EXECUTED_H
#define ANALYSIS_EXECUTED_H

#include "analysis/loop/loop_analysis.h"

/** The conditions on the counter without which control does not reach `node`: of `if (t > 0)`, of
 *  `t == 0 ? 0 : x[t - 1]`, of a preceding `if (t < m) continue;`. Returns their number; *limits is
 *  in the arena. None if nothing is known. */
unsigned executed_limits(const loop_analysis *j, const ir_node *node, const counter_limit **limits);

/** Is a piece of `outer` executed whenever `outer` is, once? */
bool executed_certainly_in(const ir_node *outer, const ir_node *node);
/** Is a piece of the body executed in each iteration, once? */
bool executed_in_each(const loop_analysis *j, const ir_node *node);

/** Have two reads of one row the same limits and checks, so that their extents are equal? */
bool source_ends_equal(const loop_source *a, const loop_source *b);

#endif
