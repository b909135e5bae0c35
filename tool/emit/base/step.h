/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Induction variables other than the counter: each iteration, of the loop or of an inner loop,
 * adds the same invariant step to them. */
#ifndef EMIT_BASE_STEP_H
#define EMIT_BASE_STEP_H

#include "emit/base/loop.h"

/** declare_entry_values declares redcc__from_N, the values on entry. If `by_header`, it does so for
 * variables that the loop's header initialises; otherwise for all other variables, and for
 * invariant steps. stepped_value returns the initialiser, " = ...", that gives private variable
 * `number` its value in an iteration. stepped_after returns its value after the executed
 * iterations, and write_stepped_values writes the assignments of these values. */
void declare_entry_values(loop_text *loop, writer *out, bool by_header);
const char *stepped_value(loop_text *loop, unsigned number);
const char *stepped_after(loop_text *loop, unsigned number);
void write_stepped_values(loop_text *loop, writer *out);
/** Writes the header's initialisations of variables that are not stepped. If the original loop runs
 * instead of the parallel form, its header repeats them. */
void write_starts(loop_text *loop, writer *out);

#endif
