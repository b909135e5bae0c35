/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Removes the statements by which an iteration leaves the loop: an assertion, or an `if` whose
 *  branch ends in exit, abort, return, goto, or a break of the loop. An `if` whose branch prints or
 *  changes other state is treated likewise, although the loop continues after it, because its
 *  output must appear in the loop's order.
 *
 *  The loop is analysed as if it had no exits. Before iterations run in parallel, one thread
 *  evaluates the exits' conditions in order until one holds (REDCC_DRY_RUN). If one does, the
 *  iterations before it run in parallel, and the original loop continues from it, or runs as a
 *  whole (plan/continuation.h). The branches themselves never run in parallel, and are not
 *  analysed. */
#ifndef ANALYSIS_LOOP_EXITS_H
#define ANALYSIS_LOOP_EXITS_H

#include "analysis/base/facts.h"

/** The condition of an assertion in the form that a C library's `assert` expands to; NULL if the
 *  expression is none. */
const ir_node *assertion_condition(const ir_node *expression);

/** Does the function's body contain an `if` whose branch prints or ends the program? If so, the
 *  body in place of a call has an exit. */
bool loop_exits_has_check(const ir_node *body);

/** Is the node an `if` whose branch ends the program? If it is removed as an exit, nothing of the
 *  branch is written again. */
bool loop_exits_ends_program(const ir_node *node);

/** Finds all exits of a loop with this body. NULL if an exit cannot be removed (its condition has
 *  effects other than assignments to automatic variables, or it is not in a block), or if there are
 *  too many. */
loop_exits *loop_exits_find(arena *a, const ir_node *body);

/** Replaces each exit by `if (condition) continue;`, with the exit's other branch. The exits have
 * no parents while they are removed. This function and loop_exits_put_back do nothing if `exits` is
 * NULL. */
void loop_exits_take_out(const loop_exits *exits);
void loop_exits_put_back(const loop_exits *exits);

/** Hides the exits' conditions too, or restores them, while the exits are removed. A condition that
 *  assigns variables stays visible, since the body must evaluate it: `if (condition) { }`. */
void loop_exits_hide(const loop_exits *exits, bool are_hidden);

/** Does the node forbid evaluating a condition that contains it before the iteration? Assignments
 * to automatic variables do not, as in `if ((p = next[i]) < 0)`. Calls are analysed like the loop's
 * other calls. */
bool loop_exits_cannot_evaluate(const ir_node *node);

/** Does the branch of an exit mention the variable? */
bool loop_exits_mention(const loop_exits *exits, const ir_variable *variable);

/** The exit that this `if` replaces; NULL if there is none. */
const loop_exit *loop_exit_at(const loop_exits *exits, const ir_node *statement);

#endif
