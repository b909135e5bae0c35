/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Loops whose OpenMP directive reduces scalars, in fixed blocks
 * (analysis/reduction/fixed_blocks.h, redcc/blocks.h). */
#ifndef EMIT_BLOCKS_H
#define EMIT_BLOCKS_H

#include "emit/write_loop.h"

/** Writes the text at the function's beginning, if the loop needs one; the text that replaces the
 *  loop's directive and header; and the text after its body, which stays in place. False, with the
 *  obstacle in *why: the loop cannot be written. */
bool write_blocks(loop_text loop, loop_piece *front, loop_piece *head, loop_piece *tail,
                  reason *why);

#endif
