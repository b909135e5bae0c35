/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The user's body for one iteration. */
#ifndef EMIT_BODY_BODY_H
#define EMIT_BODY_BODY_H

#include "emit/base/loop.h"

/** Declares functions inline if the compiler would inline them in the sequential program, because
 * they are called only once (inline.c). */
void declare_inlined(loop_text *loop, writer *out);

/** Writes the user's body for one iteration, with declarations of its private variables. */
void write_iteration(loop_text *loop, writer *out);

bool body_reads(const loop_facts *facts, const ir_variable *variable);

#endif
