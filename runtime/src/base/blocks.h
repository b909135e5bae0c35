/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Memory mapped by the runtime itself. The runtime does not use malloc, because the program may
 * define its own, which may support only the threads that the program creates, not those of OpenMP.
 * Every function is thread-safe.
 */
#ifndef REDCC_BLOCKS_H
#define REDCC_BLOCKS_H

#include <stdbool.h>
#include <stddef.h>

/** Allocates at least *bytes bytes, at a multiple of 64. Sets *bytes to the actual size, which is
 * needed to free the block. The block is not initialised. A large block may be one that was cached,
 * if `keep` is set. NULL: out of memory. */
void *redcc_block_alloc(size_t *bytes, bool keep);

/** Frees a block of `bytes` bytes, the size that redcc_block_alloc has set. A large block may be
 * cached if `keep` is set. */
void redcc_block_free(void *block, size_t bytes, bool keep);

/** Must be called in a forked process. Another thread of the parent may have held the lock at the
 * fork, so memory that was free then is not used again. */
void redcc_blocks_forked(void);

#endif
