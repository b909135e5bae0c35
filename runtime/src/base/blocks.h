/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Blocks of memory mapped by ourselves. The program's malloc may be one of its own, made for the
 * threads that it has; and those that OpenMP adds are none of them. Every function is thread-safe.
 */
#ifndef REDCC_BLOCKS_H
#define REDCC_BLOCKS_H

#include <stdbool.h>
#include <stddef.h>

/** At least *bytes bytes, at a multiple of 64; sets *bytes to how many there are, by which the
 * block is given back. Not initialised. keep: blocks given back may be kept for others. NULL: there
 * is no memory. */
void *redcc_block_take(size_t *bytes, bool keep);

/** Gives back a block of `bytes` bytes. */
void redcc_block_give(void *block, size_t bytes, bool keep);

/** To be called in a new process, where other threads may have been at it: what was free is not
 *  used again. */
void redcc_blocks_forked(void);

#endif
