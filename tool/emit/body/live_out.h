/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Private variables whose last value is wanted after the loop. */
#ifndef EMIT_BODY_LIVE_OUT_H
#define EMIT_BODY_LIVE_OUT_H

#include "emit/base/loop.h"

/** Of those that each iteration assigns. */
/** The variables themselves, in a thread; where the last values go; */
void declare_live_privates(loop_text *loop, writer *out);
void declare_live_outs(loop_text *loop, writer *out);
/** Stores the last values, of the thread that has them; or from there into the user's variables. */
void write_live_outs(loop_text *loop, writer *out, bool into_variables);

/** Of those that only some iterations assign: what
 *  notes the value and when it was assigned, of all threads or of one in the region; */
void declare_conditional_live_outs(loop_text *loop, writer *out, bool in_region);
/** the note after an assignment of private variable `number`; */
void write_note(loop_text *loop, writer *out, unsigned number);
/** the latest of all threads', at the end of the region; and from there to the variables. */
void gather_conditional_live_outs(loop_text *loop, writer *out);
void take_conditional_live_outs(loop_text *loop, writer *out);

#endif
