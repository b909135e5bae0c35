/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Floating scalars that inner loops accumulate into (redcc/series.h). */
#ifndef EMIT_BODY_SERIES_H
#define EMIT_BODY_SERIES_H

#include "emit/base/extra.h"
#include "emit/base/loop.h"

/** Before the call: writes the requests to the runtime, and storage for the sums. */
void declare_series(loop_text *loop, writer *out);
/** Calls `take` for each value that slice, body and threads get for the series. */
void for_each_series_value(loop_text *loop, void (*take)(void *to, extra_value value), void *to);
/** Is the scalar a local variable, which is passed by value? */
bool is_scalar_by_value(const loop_text *loop, unsigned number);
/** The code of each thread: declare_thread_series writes declarations; join_series the statements
 * that begin its part of the series; finish_series its last statements. series_condition is the
 * condition under which it continues with the loop. */
void declare_thread_series(loop_text *loop, writer *out);
void join_series(loop_text *loop, writer *out);
const char *series_condition(loop_text *loop);
void finish_series(loop_text *loop, writer *out);
/** The statement after a tile that adds the operands of a completed band (a group of rows); "":
 * there is no series. */
const char *series_of_band(loop_text *loop);
/** At the beginning of an iteration: begins its operands; in a tile, resumes them. */
void begin_series(loop_text *loop, writer *out);
/** At the end of a row's inner iterations in a tile: suspends the iteration's operands. */
void leave_series(loop_text *loop, writer *out);
/** In place of update `number`: appends its operand `value`. */
void write_series_operand(loop_text *loop, writer *out, unsigned number, const char *value);
/** After the loop: writes the assignments of the scalars. */
void take_series(loop_text *loop, writer *out);

#endif
