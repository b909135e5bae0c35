/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A copy of a loop without its OpenMP directives (docs/soundness.md). */
#ifndef EMIT_SEQUENTIAL_COPY_H
#define EMIT_SEQUENTIAL_COPY_H

#include "emit/base/loop.h"

/** Declares redcc__replaces, which tells at run time whether the loop may be executed without its
 * directives. Writes nothing for a loop without directives. */
void declare_replaces(loop_text *loop, writer *out);

/** A further condition for running in parallel, "... && "; "" for a loop without directives. */
const char *replaced_condition(loop_text *loop);

/** The expression of a clause, with marks on its names (origin.h). */
const char *clause_expression(const loop_text *loop, const char *whole);

/** Writes the number of threads that the directive's clauses ask for, if any. */
void write_team(loop_text *loop, writer *out);

/** Writes, after an `else`: `if (redcc__replaces) {`, the loop without its directives, `} else`. */
void write_sequential_copy(loop_text *loop, writer *out);

#endif
