/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Writes the code for scalars that the loop accumulates into. */
#ifndef EMIT_BODY_SCALARS_H
#define EMIT_BODY_SCALARS_H

#include "emit/base/loop.h"

/** Each iteration records a value for update `number`: the update's operand or, if `is_made`,
 * whether the iteration executes the update. kept_operand_type returns the value's type (NULL:
 * nothing is recorded), kept_operand_name the name of the recorded values, and kept_operand_number
 * the number by which the runtime identifies them. */
const char *kept_operand_type(const loop_text *loop, unsigned number, bool is_made);
const char *kept_operand_name(loop_text *loop, unsigned number, bool is_made);
unsigned kept_operand_number(const loop_text *loop, unsigned number, bool is_made);
/** Writes, before the call, the declarations that tell the runtime which values are recorded. */
void declare_operands(loop_text *loop, writer *out);
/** Writes, at the beginning of an iteration, declarations of redcc__so_far_N, which accumulate the
 * operands of updates in inner loops. */
void declare_repeated_operands(loop_text *loop, writer *out);
/** Writes, at the beginning of an iteration, code that records that no conditional update has been
 * executed so far, and that begins the series. */
void note_no_operands(loop_text *loop, writer *out);
/** Writes, in place of update `number`, code that records its operand `value`. */
void write_operand(loop_text *loop, writer *out, unsigned number, const char *value);
/** Writes, after the loop, the updates, and the stores to own elements. */
void apply_operands(loop_text *loop, writer *out);

#endif
