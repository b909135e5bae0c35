/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Writes which iterations a fixed block (emit/blocks.h) executes: a range of the loop's iterations
 * or, with `collapse`, a range of the outer loop combined with one of the inner loop. */
#ifndef EMIT_BLOCK_RANGES_H
#define EMIT_BLOCK_RANGES_H

#include "emit/write_loop.h"

/** Declares the number of blocks, at most `most`, and the values from which their ranges are
 * computed. */
void write_counts(loop_text *loop, writer *out, int most);

/** Writes the names that write_counts declares, each after a comma, for a `shared` clause. */
void write_shared(const loop_text *loop, buffer *out);

/** If variables are `lastprivate`, writes a condition before the directive and its loop. If there
 * are no iterations, the counters are assigned and the loop is not reached. */
void write_if_any(loop_text *loop, writer *out, bool is_of_team);

/** Writes, for each counter, its first value in a block, and the bound with which the block's
 * loop compares it. */
void write_ranges(loop_text *loop, writer *out);

/** Writes the header of the loop over a block's iterations. */
void write_header(loop_text *loop, writer *out);

/** The piece that replaces the inner loop's header; its text is NULL without `collapse`. */
loop_piece inner_header(loop_text *loop);

#endif
