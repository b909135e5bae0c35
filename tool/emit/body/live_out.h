/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Live-out private variables: those whose values are used after the loop. */
#ifndef EMIT_BODY_LIVE_OUT_H
#define EMIT_BODY_LIVE_OUT_H

#include "emit/base/loop.h"

/** Declares storage for the last values of variables that each iteration assigns. */
void declare_live_outs(loop_text *loop, writer *out);
/** Writes code that stores these values in the last iteration. */
void note_live_outs(loop_text *loop, writer *out);
/** Writes, after the loop, code that copies the values to the variables. */
void take_live_outs(loop_text *loop, writer *out);

/** Declares, for each variable that only some iterations assign, storage for the value that the
 * last of these iterations in the loop's order assigned, and for that iteration's number. */
void declare_conditional_live_outs(loop_text *loop, writer *out);
/** Writes, after an assignment of private variable `number`, code that records value and
 * iteration. */
void write_note(loop_text *loop, writer *out, unsigned number);
/** Writes, at a thread's end, code that merges its values into the storage. */
void write_last_notes(loop_text *loop, writer *out);
/** Writes, after the loop, code that copies the values to the variables. */
void take_conditional_live_outs(loop_text *loop, writer *out);

#endif
