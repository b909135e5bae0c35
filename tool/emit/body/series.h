/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Floating scalars that inner loops accumulate into: redcc/series.h. */
#ifndef EMIT_BODY_SERIES_H
#define EMIT_BODY_SERIES_H

#include "emit/base/extra.h"
#include "emit/base/loop.h"

/** At the call: the requests to the runtime, and storage for the sums. */
void declare_series(loop_text *loop, writer *out);
/** The values that slice, body and each thread get for the series. */
void for_each_series_value(loop_text *loop, void (*take)(void *to, extra_value value), void *to);
/** Is the scalar a local variable, which is passed by value? */
bool is_kept_scalar(const loop_text *loop, unsigned number);
/** A thread's variables; its part; its condition for continuing; its last statements. */
void declare_thread_series(loop_text *loop, writer *out);
void join_series(loop_text *loop, writer *out);
const char *series_go_on(loop_text *loop);
void finish_series(loop_text *loop, writer *out);
/** After a tile: the sums of a band that is done. "": there are none. */
const char *series_of_band(loop_text *loop);
/** The beginning of an iteration; the text of update number `number`. */
void begin_series(loop_text *loop, writer *out);
/** The end of an iteration's turns in a tile. */
void leave_series(loop_text *loop, writer *out);
void write_series_operand(loop_text *loop, writer *out, unsigned number, const char *value);
/** After the loop: the scalars get their values. */
void take_series(loop_text *loop, writer *out);

#endif
