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
 * branches are replaced by blanks. Everything else keeps its offset. The result shares all but its
 * text and its directives with `unit`; if nothing is skipped, it is `unit` itself.
 */
const ir_unit *unit_as_compiled(arena *a, const ir_unit *unit, const analysis_result *analysis);

/** The text before and after a form that consists of the branches that this compilation takes. It
 *  defines redcc__as_compiled if a compilation takes the same branches and if OpenMP is on, or off,
 *  as it is here. Empty for loops without branches and OpenMP directives. */
void begin_as_compiled(loop_text *loop, buffer *out);
void end_as_compiled(const loop_text *loop, buffer *out);

/** Does the loop's text have conditional branches, or does it depend on whether OpenMP is on? */
bool has_branches(const loop_text *loop);

#endif
