/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The context: a struct that passes a function's values to the functions before it. Each thread
 * copies them into variables of the same names.
 */
#ifndef EMIT_CONTEXT_H
#define EMIT_CONTEXT_H

#include "emit/base/extra.h"
#include "emit/base/loop.h"

/** The values named in the text, in which `text` contains no such names of the user's; calls `take`
 *  for each. */
void for_each_extra(loop_text *loop, const char *text,
                    void (*take)(const extra_value *value, void *context), void *context);

/** The name of a pointer to it. */
const char *pointer_name(loop_text *loop, const ir_variable *variable);
/** The parameter for a variable (for an array, a pointer to its first element); and its
 *  argument. */
const char *handed_argument(loop_text *loop, const ir_variable *variable);
const char *handed_declaration(loop_text *loop, const ir_variable *variable);

/** The struct, before the function; its initialisation, at the call; and each thread's
 *  variables. */
void write_context(loop_text *loop, writer *out);
void fill_context(loop_text *loop, writer *out);
void take_context(loop_text *loop, writer *out);

#endif
