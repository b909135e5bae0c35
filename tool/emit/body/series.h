/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Floating scalars that inner loops accumulate into (redcc/series.h). */
#ifndef EMIT_BODY_SERIES_H
#define EMIT_BODY_SERIES_H

#include "emit/base/extra.h"
#include "emit/base/loop.h"

/** Writes, before the call, the requests to the runtime, and storage for the sums. */
void declare_series(loop_text *loop, writer *out);
/** Calls `take` for each value that slice, body and threads get for the series. */
void for_each_series_value(loop_text *loop, void (*take)(void *to, extra_value value), void *to);
/** Is the scalar a local variable, which is passed by value? */
bool is_scalar_by_value(const loop_text *loop, unsigned number);
/** The code of each thread. declare_thread_series writes declarations. join_series writes the
 * statements that begin the thread's part of the series. series_condition returns the condition
 * under which the thread then continues with the loop. finish_series writes the thread's last
 * statements. */
void declare_thread_series(loop_text *loop, writer *out);
void join_series(loop_text *loop, writer *out);
const char *series_condition(loop_text *loop);
void finish_series(loop_text *loop, writer *out);
/** The statement after a tile that adds the operands of a completed band (a group of rows), or ""
 * if there is no series. */
const char *series_of_band(loop_text *loop);
/** Writes, at the beginning of an iteration, code that begins the iteration's operands or, in a
 * tile, resumes them. */
void begin_series(loop_text *loop, writer *out);
/** Writes, after a row's inner iterations in a tile, code that suspends the iteration's
 * operands. */
void leave_series(loop_text *loop, writer *out);
/** Writes, in place of update `number`, code that appends its operand `value`. */
void write_series_operand(loop_text *loop, writer *out, unsigned number, const char *value);
/** Writes, after the loop, the assignments of the sums to the scalars. */
void take_series(loop_text *loop, writer *out);

#endif
