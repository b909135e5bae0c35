/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Scalars that the loop accumulates into. */
#ifndef EMIT_BODY_SCALARS_H
#define EMIT_BODY_SCALARS_H

#include "emit/base/loop.h"

/** What is kept of each iteration for update `number`: its operand or, if `is_made`, whether it has
 *  one. The type (NULL: nothing is kept), the name, and the number by which the runtime keeps it.
 */
const char *kept_operand_type(const loop_text *loop, unsigned number, bool is_made);
const char *kept_operand_name(loop_text *loop, unsigned number, bool is_made);
unsigned kept_operand_number(const loop_text *loop, unsigned number, bool is_made);
/** At the call: the requests to the runtime. */
void declare_operands(loop_text *loop, writer *out);
/** At the beginning of an iteration: variables for accumulated operands. */
void declare_repeated_operands(loop_text *loop, writer *out);
/** The same: the initial state of conditional updates. */
void note_no_operands(loop_text *loop, writer *out);
/** In place of update `number`: keeps its operand `value`. */
void write_operand(loop_text *loop, writer *out, unsigned number, const char *value);
/** After the loop: makes the updates. */
void apply_operands(loop_text *loop, writer *out);

#endif
