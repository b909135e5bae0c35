/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Induction variables other than the counter: each iteration steps them by a constant. */
#ifndef EMIT_BASE_STEP_H
#define EMIT_BASE_STEP_H

#include "emit/base/loop.h"

/** Declares their values on entry, redcc__from_N, of those that the header sets or of the others;
 *  the value with which private variable `number` begins an iteration, " = ..."; their values after
 *  the loop. */
void declare_entry_values(loop_text *loop, writer *out, bool by_header);
const char *stepped_value(loop_text *loop, unsigned number);
void write_stepped_values(loop_text *loop, writer *out);
/** Makes the header's initialisations of variables that are not stepped. The original loop repeats
 *  them. */
void write_starts(loop_text *loop, writer *out);

#endif
