/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Live-out private variables. */
#ifndef EMIT_BODY_LIVE_OUT_H
#define EMIT_BODY_LIVE_OUT_H

#include "emit/base/loop.h"

/** For those that each iteration assigns: storage for the last values; */
void declare_live_outs(loop_text *loop, writer *out);
/** stores by the last iteration; and copies to the variables. */
void note_live_outs(loop_text *loop, writer *out);
void take_live_outs(loop_text *loop, writer *out);

/** For those that only some iterations assign: storage for the latest value of all threads, and for
 *  the iteration that assigned it; */
void declare_conditional_live_outs(loop_text *loop, writer *out);
/** records it after an assignment of private variable `number`; */
void write_note(loop_text *loop, writer *out, unsigned number);
/** a thread's last statements; and copies to the variables. */
void write_last_notes(loop_text *loop, writer *out);
void take_conditional_live_outs(loop_text *loop, writer *out);

#endif
