/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loop-invariant pointers that a loop loads through other pointers, `s->atoms->U`.
 *
 * While such a loop is analysed and written, an added variable replaces each pointer. Generated
 * code loads it before the loop, though the program might not. REDCC_LOAD therefore reads without a
 * fault; if the memory is unreadable, the original loop runs.
 */
#ifndef ANALYSIS_LOOP_LOADS_H
#define ANALYSIS_LOOP_LOADS_H

#include "analysis/base/facts.h"

/** Adds a variable to the unit for each such pointer that a function loads in its loops, and that
 *  has none yet. Called before variables are analysed, and again when loops were changed. */
void loop_loads_name(ir_unit *unit);

/** The loads of such pointers in the loop's body, and the loads through which they are reached.
 *  NULL: there are none, or too many. */
loop_loads *loop_loads_find(arena *a, const ir_unit *unit, const ir_function *function,
                            const ir_node *body);

/** Replaces them by the variables; NULL: nothing to do, here and below. */
void loop_loads_take_out(const loop_loads *loads);
void loop_loads_put_back(const loop_loads *loads);

/** Is it a variable that replaces a pointer? */
bool loop_loads_has(const loop_loads *loads, const ir_variable *variable);

#endif
