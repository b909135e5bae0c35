/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Before a loop is written: what things will be called, and what forbids writing it at all. */
#ifndef EMIT_SETUP_H
#define EMIT_SETUP_H

#include "emit/loop.h"

/** setup.c: fills arrays, sources and counter_type, and records what forbids writing the loop. */
void prepare_loop(loop_text *loop);

/** setup.c: may a pointer stand for this array in the body? */
bool can_be_pointer(const loop_text *loop, const ir_variable *variable);
/** Is a macro used in the body? */
bool has_macro(const loop_text *loop);

#endif
