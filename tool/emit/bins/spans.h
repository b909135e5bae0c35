/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Text for spans: inner loops over a row, each of which becomes one record (plan/bins_span.c). The
 * record has the first element, the number of elements, and the variables that the operands use. */
#ifndef EMIT_BINS_SPANS_H
#define EMIT_BINS_SPANS_H

#include "emit/base/loop.h"
#include "emit/text/print.h"
#include "plan/bins.h"

/** The text that appends the record of a span, followed by `else`. The span's own loop, which comes
 * after this text, runs only in executions that append no records. */
const char *push_span_text(loop_text *loop, const bins_record *record, ir_c_rename name);
/** Writes the type of a span's record. */
void write_span_record(loop_text *loop, const bins_record *record, writer *out);
/** Writes the function that applies the records of a span, to the rows of one bin. */
void write_apply_span(loop_text *loop, const bins_record *record, writer *out);

#endif
