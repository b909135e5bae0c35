/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Where the blocks of `omp for` put their parts, for all threads of the team (emit/blocks.c): in
 *  the frame of the function that has the region; else in that of one thread, whose address the
 *  others get, which takes two barriers more. The thread that ends the last block combines them. */
#ifndef EMIT_TEAM_PARTS_H
#define EMIT_TEAM_PARTS_H

#include "emit/write_loop.h"

/** May they be in the function's frame? */
bool has_frame_parts(const loop_text *loop);

/** Their declaration, at the function's beginning. */
loop_piece frame_parts(loop_text *loop, int blocks);

/** At the loop: declares `redcc__parts` and `redcc__all_ended`, which lead to them and to the
 * number of blocks that are ended, and `redcc__mine`, of the thread's. */
void write_team_parts(loop_text *loop, writer *out, int blocks);

/** Before the loop's directive: threads wait for others, or get the address. */
void write_team_begin(const loop_text *loop, writer *out);

#endif
