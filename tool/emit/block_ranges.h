/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The iterations of a fixed block (emit/blocks.h): of a loop, and of the inner loop of a nest
 * below `collapse`. Then blocks are a table: each has a part of the outer loop and one of the
 * inner. */
#ifndef EMIT_BLOCK_RANGES_H
#define EMIT_BLOCK_RANGES_H

#include "emit/write_loop.h"

/** Writes the number of blocks, at most `most`, and what their ranges are computed from. */
void write_counts(loop_text *loop, writer *out, int most);

/** Writes the names that write_counts declares, each after a comma, for a clause. */
void write_shared(const loop_text *loop, buffer *out);

/** If a clause gives variables the values that they have after the last iteration, writes a
 * condition for the directive and its loop: without iterations, the counters alone are set. */
void write_if_any(loop_text *loop, writer *out, bool is_of_team);

/** Writes, for each counter, its first value in a block, and the bound with which the block's
 * loop compares it. */
void write_ranges(loop_text *loop, writer *out);

/** Writes the header of the loop over a block's iterations. */
void write_header(loop_text *loop, writer *out);

/** The text in place of the inner loop's header; its text is NULL if blocks do not divide it. */
loop_piece inner_header(loop_text *loop);

#endif
