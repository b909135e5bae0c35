/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Scalars that the loop accumulates into. */
#ifndef EMIT_BODY_SCALARS_H
#define EMIT_BODY_SCALARS_H

#include "emit/base/loop.h"

/** Operands, or whether there is one, of each iteration: the type for update `number` (NULL: it has
 *  none), the name, and the number by which the runtime keeps them. */
const char *kept_operand_type(const loop_text *loop, unsigned number, bool is_made);
const char *kept_operand_name(loop_text *loop, unsigned number, bool is_made);
unsigned kept_operand_number(const loop_text *loop, unsigned number, bool is_made);
/** At the call, the requests to the runtime; */
void declare_operands(loop_text *loop, writer *out);
/** in an iteration, variables for accumulated operands, the initial state of conditional updates,
 *  and the text of update `number`; */
void declare_repeated_operands(loop_text *loop, writer *out);
void note_no_operands(loop_text *loop, writer *out);
void write_operand(loop_text *loop, writer *out, unsigned number, const char *value);
/** after the loop, the updates themselves. */
void apply_operands(loop_text *loop, writer *out);

#endif
