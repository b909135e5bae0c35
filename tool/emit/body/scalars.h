/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Scalars that the loop accumulates into. */
#ifndef EMIT_BODY_SCALARS_H
#define EMIT_BODY_SCALARS_H

#include "emit/base/loop.h"

/** What each iteration keeps for update `number`: its operand or, if `is_made`, whether it executes
 * the update. The functions give the type (NULL: nothing is kept), the name of the kept values, and
 * the number by which the runtime knows them. */
const char *kept_operand_type(const loop_text *loop, unsigned number, bool is_made);
const char *kept_operand_name(loop_text *loop, unsigned number, bool is_made);
unsigned kept_operand_number(const loop_text *loop, unsigned number, bool is_made);
/** At the call: tells the runtime which values the iterations keep. */
void declare_operands(loop_text *loop, writer *out);
/** At the beginning of an iteration: declares redcc__so_far_N, in which an iteration accumulates
 * the operands of an update in an inner loop. */
void declare_repeated_operands(loop_text *loop, writer *out);
/** At the beginning of an iteration: records that conditional updates are not executed so far, and
 * begins the series. */
void note_no_operands(loop_text *loop, writer *out);
/** In place of update `number`: keeps its operand `value`. */
void write_operand(loop_text *loop, writer *out, unsigned number, const char *value);
/** After the loop: makes the updates, and stores own elements. */
void apply_operands(loop_text *loop, writer *out);

#endif
