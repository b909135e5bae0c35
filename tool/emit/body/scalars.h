/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Scalars that the loop accumulates into. */
#ifndef EMIT_BODY_SCALARS_H
#define EMIT_BODY_SCALARS_H

#include "emit/base/loop.h"

/** Operands, or whether there is one, of each iteration: the type of update `number`'s (NULL: it
 * has none), the name, and the number by which the runtime keeps them. */
const char *kept_operand_type(const loop_text *loop, unsigned number, bool is_made);
const char *kept_operand_name(loop_text *loop, unsigned number, bool is_made);
unsigned kept_operand_number(const loop_text *loop, unsigned number, bool is_made);
/** At the call, what the runtime is to keep; */
void declare_operands(loop_text *loop, writer *out);
/** in an iteration, variables for what is put together, that no update was executed yet of those
 *  that may not be, and what number `number` does; */
void declare_repeated_operands(loop_text *loop, writer *out);
void note_no_operands(loop_text *loop, writer *out);
void write_operand(loop_text *loop, writer *out, unsigned number, const char *value);
/** after the loop, the updates themselves. */
void apply_operands(loop_text *loop, writer *out);

#endif
