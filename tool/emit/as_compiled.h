/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loops with conditional directives in their text. What is written for them is made of the branches
 * that this compilation takes. So it stands under conditions by which any other compilation of the
 * result finds the loop as it was, every byte of it.
 */
#ifndef EMIT_AS_COMPILED_H
#define EMIT_AS_COMPILED_H

#include "analysis/analysis.h"
#include "emit/base/loop.h"

/**
 * The unit as the writers of text see it: in loops that are to be written, conditional directives
 * and the branches that they leave out are blanks. All else has the place that it had. It shares
 * everything but its text and its directives with `unit`, and is that itself where there is nothing
 * to leave out.
 */
const ir_unit *unit_as_compiled(arena *a, const ir_unit *unit, const analysis_result *analysis);

/** as_compiled.c: before text that is made of the branches in the loop that this compilation takes,
 *  and after it: they define a word where it takes the same, and where OpenMP is off as it is here.
 *  Nothing, of loops without branches and without OpenMP directives. */
void begin_as_compiled(loop_text *loop, buffer *out);
void end_as_compiled(const loop_text *loop, buffer *out);

/** Has it branches, or OpenMP directives that this compilation passes over? */
bool has_branches(const loop_text *loop);

#endif
