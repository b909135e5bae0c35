/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Private variables whose last value is wanted after the loop. */
#ifndef EMIT_BODY_LIVE_OUT_H
#define EMIT_BODY_LIVE_OUT_H

#include "emit/base/loop.h"

/** Of those that each iteration assigns: where the last values go; */
void declare_live_outs(loop_text *loop, writer *out);
/** the last iteration leaves them there; and from there to the variables. */
void note_live_outs(loop_text *loop, writer *out);
void take_live_outs(loop_text *loop, writer *out);

/** Of those that only some iterations assign: what notes the latest of all threads' values, and
 *  when it was assigned; */
void declare_conditional_live_outs(loop_text *loop, writer *out);
/** the note after an assignment of private variable `number`; */
void write_note(loop_text *loop, writer *out, unsigned number);
/** what a thread does at its end; and from there to the variables. */
void write_last_notes(loop_text *loop, writer *out);
void take_conditional_live_outs(loop_text *loop, writer *out);

#endif
