/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Scalars that the loop accumulates into. */
#ifndef EMIT_BODY_SCALARS_H
#define EMIT_BODY_SCALARS_H

#include "emit/base/loop.h"

/** Room for the operands that each iteration keeps of scalar updates; whether there was
 *  memory for it, as a condition (NULL: there are no such updates); */
void declare_operands(loop_text *loop, writer *out);
const char *operands_are_there(loop_text *loop);
/** in an iteration, variables for what is put together, that no update was executed yet of those
 *  that may not be, and what number `number` does; */
void declare_repeated_operands(loop_text *loop, writer *out);
void note_no_operands(loop_text *loop, writer *out);
void write_operand(loop_text *loop, writer *out, unsigned number, const char *value);
/** after the loop, the updates themselves. */
void apply_operands(loop_text *loop, writer *out);

#endif
