/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Induction variables besides the counter: each iteration moves them by a constant. */
#ifndef EMIT_BASE_STEP_H
#define EMIT_BASE_STEP_H

#include "emit/base/loop.h"

/** Their values when the loop is
 *  entered, as redcc__from_N, those that the header gives them or the others'; what private
 * variable `number` begins an iteration with, " = ..."; their values after the loop. */
void declare_entry_values(loop_text *loop, writer *out, bool by_header);
const char *stepped_value(loop_text *loop, unsigned number);
void write_stepped_values(loop_text *loop, writer *out);
/** What the header sets of the variables that are not stepped. The original does it again. */
void write_starts(loop_text *loop, writer *out);

#endif
