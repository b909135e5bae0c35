/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Storage, shared by a team, for the partial results of the blocks of an `omp for`
 * (emit/blocks.c). The storage is in the frame of the function that contains the parallel region.
 * If that is impossible, it is in the frame of one thread, which gives its address to the other
 * threads; that takes two more barriers. The thread that completes the last block combines the
 * results. */
#ifndef EMIT_TEAM_PARTS_H
#define EMIT_TEAM_PARTS_H

#include "emit/write_loop.h"

/** May the storage be in the function's frame? */
bool has_frame_parts(const loop_text *loop);

/** Declares the storage, at the function's beginning. */
loop_piece frame_parts(loop_text *loop, int blocks);

/** Declares, before the loop, `redcc__parts`, a pointer to the storage; `redcc__all_ended`, a
 * pointer to the number of blocks that the team has ended; and `redcc__mine`, the number that the
 * thread has ended. */
void write_team_parts(loop_text *loop, writer *out, int blocks);

/** Writes the text before the loop's directive: the threads wait for each other, or get the
 * address. */
void write_team_begin(const loop_text *loop, writer *out);

#endif
