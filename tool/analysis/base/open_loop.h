/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Loops without an upper bound, whose end only their data tell:
 *
 *      for (i = 0; (j = list[i]) > -1; i++) ...        for (p = list; *p != END; p++) ...
 *
 *  Such a loop is analysed as one that counts to a limit which its counter never reaches, and that
 *  an iteration leaves if the condition does not hold (loop_exits.h):
 *
 *      for (i = 0; i < 2147483647; i++) { if (!((j = list[i]) > -1)) break; ... }
 *
 *  The limit decides nothing. The iterations before the one that leaves run in parallel; then the
 *  original loop continues, whether or not the limit was reached. */
#ifndef ANALYSIS_OPEN_LOOP_H
#define ANALYSIS_OPEN_LOOP_H

#include "analysis/base/facts.h"

/** Finds the exits of a loop without a bound; NULL if it has another form. `function` contains the
 *  loop. */
loop_exits *open_loop_find(arena *a, ir_function *function, ir_node *loop);

/** Gives the loop its limit and its exit, or takes them away again. loop_exits_take_out and
 *  loop_exits_put_back call these. */
void open_loop_limit(const open_loop *open);
void open_loop_restore(const open_loop *open);

#endif
