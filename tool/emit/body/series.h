/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Floating scalars that loops inside accumulate into: redcc/series.h. */
#ifndef EMIT_BODY_SERIES_H
#define EMIT_BODY_SERIES_H

#include "emit/base/loop.h"

/** Room for the series before the loop; that it is there, as conditions behind `text` (or NULL). */
void declare_series(loop_text *loop, writer *out);
const char *series_are_there(loop_text *loop, const char *text);
/** Adds the variables of which each thread needs the value that they have before the loop. */
void add_series_variables(loop_text *loop, buffer *clause);
/** In the region: each thread's part; the condition under which it goes on executing; what it does
 *  in the end. */
void join_series(loop_text *loop, writer *out);
const char *series_go_on(loop_text *loop);
void finish_series(loop_text *loop, writer *out);
/** An iteration begins; what update number `number` does in it. */
void begin_series(loop_text *loop, writer *out);
void write_series_operand(loop_text *loop, writer *out, unsigned number, const char *value);
/** After the loop: the scalars get their values, and the memory is given back. */
void take_series(loop_text *loop, writer *out);
void give_series(loop_text *loop, writer *out);

#endif
