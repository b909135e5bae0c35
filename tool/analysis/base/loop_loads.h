/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Replaces loop-invariant pointers that a loop loads through other pointers, as in `s->atoms->U`.
 *
 *  While such a loop is analysed and its code is generated, an added variable replaces each of
 *  these pointers. Generated code loads the pointer before the loop, although the program might
 *  never load it. It therefore uses REDCC_LOAD, which detects unreadable memory instead of
 *  faulting; in that case the original loop runs. */
#ifndef ANALYSIS_LOOP_LOADS_H
#define ANALYSIS_LOOP_LOADS_H

#include "analysis/base/facts.h"

/** Adds a variable to the unit for each such pointer that a function loads in a loop, unless it has
 *  one already. Call it before variables are analysed, and again when loops were changed. */
void loop_loads_name(ir_unit *unit);

/** The loads of such pointers in the loop's body, and the loads through which they are reached.
 *  NULL if there are none or too many. */
loop_loads *loop_loads_find(arena *a, const ir_unit *unit, const ir_function *function,
                            const ir_node *body);

/** Replaces the loads by the variables. This function and loop_loads_put_back do nothing if `loads`
 *  is NULL. */
void loop_loads_take_out(const loop_loads *loads);
void loop_loads_put_back(const loop_loads *loads);

/** Is it a variable that replaces a pointer? */
bool loop_loads_has(const loop_loads *loads, const ir_variable *variable);

#endif
