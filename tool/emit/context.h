/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The context: a struct by which the user's function passes values to the functions that are
 * written before it. Each thread copies them into variables of the same names.
 */
#ifndef EMIT_CONTEXT_H
#define EMIT_CONTEXT_H

#include "emit/base/extra.h"
#include "emit/base/loop.h"

/** Calls `take` for each of the translator's values (extra.h) that the text names. */
void for_each_extra(loop_text *loop, const char *text,
                    void (*take)(const extra_value *value, void *context), void *context);

/** The name of a pointer to the variable. */
const char *pointer_name(loop_text *loop, const ir_variable *variable);
/** passed_argument returns the argument, and passed_declaration the parameter, by which a function
 *  gets the variable. For an array this is a pointer to its first element. */
const char *passed_argument(loop_text *loop, const ir_variable *variable);
const char *passed_declaration(loop_text *loop, const ir_variable *variable);

/** write_context writes the struct's type, before the function. fill_context writes its
 * initialisation, before the call. take_context writes the declarations of each thread's
 * variables. */
void write_context(loop_text *loop, writer *out);
void fill_context(loop_text *loop, writer *out);
void take_context(loop_text *loop, writer *out);

#endif
