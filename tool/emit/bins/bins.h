/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Writes the form for in-order binning, which plan/bins.h explains: text for a loop's body and for
 * its description. */
#ifndef EMIT_BINS_BINS_H
#define EMIT_BINS_BINS_H

#include "emit/base/loop.h"
#include "plan/bins.h"

/** The type of a record's value, by a name that needs no declaration; NULL for VALUE_NONE. */
const char *bins_kind_text(value_kind kind);
/** The type of a stream's records, or NULL if they have no values. */
const char *bins_record_name(loop_text *loop, unsigned stream);
/** The text before an update of the element at `address`; `name` spells variables. */
const char *bins_update(loop_text *loop, const reduction_update *update, const char *address,
                        ir_c_rename name);
/** The text before an inner loop that appends the records of its updates (a nest or a span), one
 * record for each update. NULL if the updates append their records themselves. */
const char *bins_appends(loop_text *loop, const ir_node *statement, ir_c_rename name);
/** Do apply functions use the context, so that it must be declared before them? */
bool bins_have_spans(const loop_text *loop);
/** Writes the apply functions. */
void write_bins(loop_text *loop, writer *out);
/** Writes the descriptions of the bins_stream_count streams. */
void write_streams(loop_text *loop, writer *out);
unsigned bins_stream_count(const loop_text *loop);
/** Does a separate function execute iterations whose updates are made on private copies?
 * bins_copied: arguments of its REDCC_COPY_CHUNK. */
bool bins_have_copier(const loop_text *loop);
const char *bins_copied(const loop_text *loop);
/** Arguments of REDCC_PARALLEL_BINNED. bins_phase returns those that name the sources to log, and
 * say how updates are made on private copies. streams_argument returns the streams. */
const char *bins_phase(loop_text *loop);
const char *streams_argument(loop_text *loop);

#endif
