/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The slice of an iteration, which logs the addresses that it touches. */
#ifndef EMIT_SLICE_SLICE_H
#define EMIT_SLICE_SLICE_H

#include "emit/base/loop.h"

/** The statements of one iteration, with the macros of loop.h; sets is_mentioned for each variable,
 *  by its number, that they name. */
void write_slice_statements(loop_text *loop, writer *out, bool *is_mentioned);

/** In the inspector, the name of the counter number `depth` of a source's loops. */
const char *source_loop_counter(arena *a, unsigned depth);
/** The header of that loop, which precedes a block; an `if` if one iteration logs all rows. */
const char *source_loop_header(arena *a, const loop_source *read, unsigned depth,
                               const char *counter, const char *bound, bool is_span);

#endif
