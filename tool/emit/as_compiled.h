/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loops with conditional directives in their text. Their parallel form consists of the branches
 * that this compilation takes. So conditions enclose it: a compilation of the result that takes
 * other branches gets the original loop, byte for byte.
 */
#ifndef EMIT_AS_COMPILED_H
#define EMIT_AS_COMPILED_H

#include "analysis/analysis.h"
#include "emit/base/loop.h"

/**
 * The unit as seen by code generation: in loops to be written, directives that a copy can omit and
 * skipped branches are replaced by blanks. Everything else keeps its offset. The result shares all
 * but its text and its directives with `unit`; if nothing is replaced, it is `unit` itself.
 */
const ir_unit *unit_as_compiled(arena *a, const ir_unit *unit, const analysis_result *analysis);

/** Write the text before such a form, which defines redcc__as_compiled if a compilation takes the
 * same branches and has OpenMP on, or off, as this one; and the text after it, which undefines it.
 * Both are empty unless has_branches. */
void begin_as_compiled(loop_text *loop, buffer *out);
void end_as_compiled(const loop_text *loop, buffer *out);

/** Is there a conditional directive between the function's beginning and the loop's end, or does
 * the loop depend on whether OpenMP is on? */
bool has_branches(const loop_text *loop);

#endif
