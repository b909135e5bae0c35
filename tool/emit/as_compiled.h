/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loops with conditional directives (#if) in their text. The parallel form consists of the branches
 * that this compilation takes, and is enclosed in the same conditions. If other branches are taken
 * when the output is compiled, the original loop is compiled, byte for byte.
 */
#ifndef EMIT_AS_COMPILED_H
#define EMIT_AS_COMPILED_H

#include "analysis/analysis.h"
#include "emit/base/loop.h"

/**
 * The unit as code generation reads it: in loops to be transformed, skipped branches and directives
 * that a copy can omit are replaced by blanks. Everything else keeps its offset. The result shares
 * all but its text and its directives with `unit`; if nothing is replaced, it is `unit` itself.
 */
const ir_unit *unit_as_compiled(arena *a, const ir_unit *unit, const analysis_result *analysis);

/** begin_as_compiled writes the text before a parallel form. This text defines redcc__as_compiled
 * if a compilation takes the same branches as this one, and also enables OpenMP if and only if
 * this one does. end_as_compiled writes the text after the form, which undefines the macro. Both
 * write nothing unless has_branches is true. */
void begin_as_compiled(loop_text *loop, buffer *out);
void end_as_compiled(const loop_text *loop, buffer *out);

/** Is there a conditional directive between the function's beginning and the loop's end, or does
 * the loop's translation depend on whether OpenMP is enabled? */
bool has_branches(const loop_text *loop);

#endif
