/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Writes loops whose OpenMP directive reduces scalars. Their iterations are divided into fixed
 * blocks, so that the result is the same for every number of threads
 * (analysis/reduction/fixed_blocks.h, redcc/blocks.h). */
#ifndef EMIT_BLOCKS_H
#define EMIT_BLOCKS_H

#include "emit/write_loop.h"

/** The texts written for a loop. Its body stays in place. A piece that is not needed has the text
 * NULL. */
typedef struct block_pieces {
    loop_piece front; /* at the function's beginning */
    loop_piece head;  /* replaces the loop's directive and header */
    loop_piece inner; /* replaces the header of a nested loop */
    loop_piece tail;  /* after the loop's body */
} block_pieces;

/** Returns false, with the obstacle in *why, if the loop cannot be written. */
bool write_blocks(loop_text loop, block_pieces *pieces, reason *why);

#endif
