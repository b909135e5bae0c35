/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Statements by which an iteration leaves the loop for good: an assertion, or an `if` whose branch
 * ends in exit, abort, return, goto, or a break of the loop.
 *
 * The loop without them is the loop in which none of them leaves. Before any iteration is executed
 * in parallel, one thread evaluates their conditions for all iterations, in order and up to the
 * first that holds (REDCC_DRY_RUN): where one holds, nothing has been done, and the original loop
 * runs. So what stands in the branches is never executed in parallel, and is not looked at.
 */
#ifndef ANALYSIS_LOOP_EXITS_H
#define ANALYSIS_LOOP_EXITS_H

#include "analysis/base/facts.h"

/** The condition of an assertion, as a C library's `assert` makes it; NULL: it is none. */
const ir_node *assertion_condition(const ir_node *expression);

/** All of a loop whose iterations execute `body`. NULL: one of them cannot be taken out: its
 *  condition has effects, or it stands in no block. */
loop_exits *loop_exits_find(arena *a, const ir_node *body);

/** Puts the bare conditions in the place of the statements; these have no parents then. NULL:
 *  nothing to do, here and below. */
void loop_exits_take_out(const loop_exits *exits);
void loop_exits_put_back(const loop_exits *exits);

/** While they are taken out: takes the conditions away as well, and gives them back. */
void loop_exits_hide(const loop_exits *exits, bool are_hidden);

/** The exit whose condition stands here; NULL: none. */
const loop_exit *loop_exit_at(const loop_exits *exits, const ir_node *statement);

#endif
