/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The user's body for one iteration. */
#ifndef EMIT_BODY_BODY_H
#define EMIT_BODY_BODY_H

#include "emit/base/loop.h"

/** inline.c: preserves the inlining of functions that the compiler inlines in the sequential
 *  program because they have a single call. */
void declare_inlined(loop_text *loop, writer *out);

/** body.c: the user's body for one iteration, with the counter and private variables declared. */
void write_iteration(loop_text *loop, writer *out);

bool body_reads(const loop_facts *facts, const ir_variable *variable);

#endif
