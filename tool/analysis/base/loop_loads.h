/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Pointers that a loop reads through other pointers, `s->atoms->U`, and that it leaves as they are.
 *
 * While such a loop is analysed and written, a variable of the translator's own stands for each of
 * them. Generated code gives it the pointer's value before the loop, without a fault where the
 * memory cannot be read (REDCC_LOAD): the program may read it under conditions only. Where one
 * cannot be read the original loop runs.
 */
#ifndef ANALYSIS_LOOP_LOADS_H
#define ANALYSIS_LOOP_LOADS_H

#include "analysis/base/facts.h"

/** Gives the unit variables, one for each such pointer that a function reads in its loops. Once,
 *  before anything is known of its variables. */
void loop_loads_name(ir_unit *unit);

/** Those of the loop's body, with those on the way to them. NULL: there are none, or too many. */
loop_loads *loop_loads_find(arena *a, const ir_unit *unit, const ir_function *function,
                            const ir_node *body);

/** Puts the variables in their place; NULL: nothing to do, here and below. */
void loop_loads_take_out(const loop_loads *loads);
void loop_loads_put_back(const loop_loads *loads);

/** Is it a variable that stands for a pointer? */
bool loop_loads_has(const loop_loads *loads, const ir_variable *variable);

#endif
