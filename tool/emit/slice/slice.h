/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The slice of an iteration: code that logs the addresses that the iteration touches. */
#ifndef EMIT_SLICE_SLICE_H
#define EMIT_SLICE_SLICE_H

#include "emit/base/loop.h"

/** Writes the statements of one iteration, with the macros of redcc/slice.h. Sets is_mentioned for
 * each variable that they name. */
void write_slice_statements(loop_text *loop, writer *out, bool *is_mentioned);

/** The name, in the inspector, of the counter of loop `depth` around a source; 0 is the outermost
 * loop. */
const char *source_loop_counter(arena *a, unsigned depth);
/** Returns the header of loop `depth` around the source `read`; if one iteration logs all rows
 *  (is_span), an `if` instead of a `for`. */
const char *source_loop_header(arena *a, const loop_source *read, unsigned depth,
                               const char *counter, const char *bound, bool is_span);

#endif
