/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Statements by which an iteration leaves the loop: an assertion, or an `if` whose branch ends in
 * exit, abort, return, goto, or a break of the loop. An `if` whose branch prints, or changes other
 * state, is treated likewise although the loop continues, because its output must come in the
 * loop's order.
 *
 * The loop is analysed as if none left it. Before iterations run in parallel, one thread evaluates
 * their conditions in order, up to the first that holds (REDCC_DRY_RUN). If one holds, nothing has
 * been executed, and the original loop runs. So the branches never run in parallel, and are not
 * analysed.
 */
#ifndef ANALYSIS_LOOP_EXITS_H
#define ANALYSIS_LOOP_EXITS_H

#include "analysis/base/facts.h"

/** The condition of an assertion, in the form of a C library's `assert`; NULL: it is none. */
const ir_node *assertion_condition(const ir_node *expression);

/** Finds all exits of a loop whose iterations execute `body`. NULL: one of them cannot be
 * removed (its condition has effects, or it is not in a block), or there are too many. */
loop_exits *loop_exits_find(arena *a, const ir_node *body);

/** Replaces each statement by `if (condition) continue;`. The statements have no parents then.
 * NULL: nothing to do, here and below. */
void loop_exits_take_out(const loop_exits *exits);
void loop_exits_put_back(const loop_exits *exits);

/** While they are removed: hides the conditions as well, or restores them. */
void loop_exits_hide(const loop_exits *exits, bool are_hidden);

/** The exit that this `if` replaces; NULL: none. */
const loop_exit *loop_exit_at(const loop_exits *exits, const ir_node *statement);

#endif
