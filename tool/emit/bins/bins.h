/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The form for in-order binning, as the body and the description of a loop have it. */
#ifndef EMIT_BINS_BINS_H
#define EMIT_BINS_BINS_H

#include "emit/base/loop.h"

/** What goes before an update whose element has this address; */
const char *bins_update(loop_text *loop, const reduction_update *update, const char *address);
/** What goes in front of a loop over constants, to append what it adds; NULL: nothing.
 */
const char *bins_appends(loop_text *loop, const ir_node *statement, ir_c_rename name);
/** What applies records; the streams, and how many; the arguments of
 *  REDCC_PARALLEL_BINNED that say so. */
void write_bins(loop_text *loop, writer *out);
void write_streams(loop_text *loop, writer *out);
unsigned bins_stream_count(const loop_text *loop);
const char *bins_phase(loop_text *loop);
const char *streams_argument(loop_text *loop);

#endif
