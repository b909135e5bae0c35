/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Determines in which iterations a node of the loop's body is executed, as far as the counter
 *  decides it. */
#ifndef ANALYSIS_EXECUTED_H
#define ANALYSIS_EXECUTED_H

#include "analysis/loop/loop_analysis.h"

/** Finds conditions on the counter that hold whenever control reaches `node`: from `if (t > 0)`,
 *  from `t == 0 ? 0 : x[t - 1]`, from a preceding `if (t < m) continue;`. Stores them in *limits,
 *  in the arena, and returns how many there are; 0 if nothing is known. */
unsigned executed_limits(const loop_analysis *j, const ir_node *node, const counter_limit **limits);

/** Is `node`, which is in `outer`, executed exactly once whenever `outer` is executed? */
bool executed_certainly_in(const ir_node *outer, const ir_node *node);
/** Is the node of the body executed exactly once in each iteration? */
bool executed_in_each(const loop_analysis *j, const ir_node *node);
/** Is it executed exactly once in each iteration that does not leave the loop? */
bool executed_in_each_staying(const loop_analysis *j, const ir_node *node);

/** Do two reads of the same row have the same limits and checks, so that their extents are
 *  equal? */
bool source_ends_equal(const loop_source *a, const loop_source *b);

#endif
