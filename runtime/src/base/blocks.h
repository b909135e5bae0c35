/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Memory mapped by the runtime itself. The program may define its own malloc, which may support
 * only the threads that the program knows of, and OpenMP's are not among them. Every function is
 * thread-safe.
 */
#ifndef REDCC_BLOCKS_H
#define REDCC_BLOCKS_H

#include <stdbool.h>
#include <stddef.h>

/** At least *bytes bytes, at a multiple of 64; sets *bytes to the actual size, which is needed to
 *  free it. Not initialised. keep: freed blocks may be cached. NULL: no memory. */
void *redcc_block_take(size_t *bytes, bool keep);

/** Frees a block of `bytes` bytes. */
void redcc_block_give(void *block, size_t bytes, bool keep);

/** Must be called in a forked process, because other threads may have held the lock: memory that
 *  was free is not used again. */
void redcc_blocks_forked(void);

#endif
