/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Loops whose OpenMP directive reduces scalars, in fixed blocks
 * (analysis/reduction/fixed_blocks.h, redcc/blocks.h). */
#ifndef EMIT_BLOCKS_H
#define EMIT_BLOCKS_H

#include "emit/write_loop.h"

/** The texts of a loop, whose body stays in place; those that it does not need are NULL. */
typedef struct block_pieces {
    loop_piece front; /* at the function's beginning */
    loop_piece head;  /* replaces the loop's directive and header */
    loop_piece inner; /* replaces the header of a nested loop */
    loop_piece tail;  /* after the loop's body */
} block_pieces;

/** False, with the obstacle in *why: the loop cannot be written. */
bool write_blocks(loop_text loop, block_pieces *pieces, reason *why);

#endif
