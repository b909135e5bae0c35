/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Loops without an upper bound, whose end only their data tell:
 *
 *      for (i = 0; (j = list[i]) > -1; i++) ...        while ((j = *p++) != END) ...
 *
 *  Such a loop is analysed as one that counts to a limit which its counter never reaches, and that
 *  an iteration leaves if the condition does not hold (loop_exits.h):
 *
 *      for (i = 0; i < 2147483647; i++) { if (!((j = list[i]) > -1)) break; ... }
 *
 *  The counter may be stepped by the header, at the end of the body, or by an expression in the
 *  condition or in the body, after which the iteration does not use it (step_inside.h).
 *
 *  The limit decides nothing. The iterations before the one that leaves run in parallel; then the
 *  original loop continues, whether or not the limit was reached. */
#ifndef ANALYSIS_OPEN_LOOP_H
#define ANALYSIS_OPEN_LOOP_H

#include "analysis/base/facts.h"

/** Finds the exits of a loop without a bound; NULL if it has another form. `function` contains the
 *  loop, and `text` is its source. */
loop_exits *open_loop_find(arena *a, const source *text, ir_function *function, ir_node *loop);

/** Gives the loop its limit and its exit, or takes them away again. loop_exits_take_out and
 *  loop_exits_put_back call these. */
void open_loop_limit(const open_loop *open);
void open_loop_restore(const open_loop *open);

#endif
