/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loops with conditional directives in their text. Their parallel form consists of the branches
 * that this compilation takes. So it is enclosed in conditions under which any other compilation of
 * the result finds the original loop, byte for byte.
 */
#ifndef EMIT_AS_COMPILED_H
#define EMIT_AS_COMPILED_H

#include "analysis/analysis.h"
#include "emit/base/loop.h"

/**
 * The unit as seen by code generation: in loops to be written, conditional directives and skipped
 * branches are replaced by blanks. Everything else keeps its offset. It shares all but its text and
 * its directives with `unit`, and is that itself if nothing is skipped.
 */
const ir_unit *unit_as_compiled(arena *a, const ir_unit *unit, const analysis_result *analysis);

/** as_compiled.c: text before and after a form made of the branches that this compilation takes: it
 *  defines a word if the same branches are taken, and if OpenMP is off as it is here. Empty for
 *  loops without branches and OpenMP directives. */
void begin_as_compiled(loop_text *loop, buffer *out);
void end_as_compiled(const loop_text *loop, buffer *out);

/** Does it have branches, or OpenMP directives that this compilation ignores? */
bool has_branches(const loop_text *loop);

#endif
