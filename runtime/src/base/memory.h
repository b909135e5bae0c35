/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Allocates all memory of the runtime. Allocations are counted and limited by REDCC_MEMORY_LIMIT,
 * and tests can make them fail. The memory never comes from the program's malloc (blocks.h), except
 * under AddressSanitizer. Every function is thread-safe.
 */
#ifndef REDCC_MEMORY_H
#define REDCC_MEMORY_H

#include <stdbool.h>
#include <stddef.h>

/** Allocates `bytes` bytes, aligned to a cache line. The memory is not initialised, so that the
 * first thread to write a page determines its NUMA node. NULL if out of memory, or if the limit
 * would be exceeded. */
void *redcc_memory_alloc(size_t bytes);

/** As redcc_memory_alloc, for `count` items of `size` bytes, all zero. */
void *redcc_memory_alloc_zeroed(size_t count, size_t size);

/** A copy of the text; NULL: out of memory. */
char *redcc_memory_copy_text(const char *text);

/** Resizes a block and keeps its contents; returns the new block. If `block` is NULL, allocates
 * one. NULL: out of memory, and `block` is unchanged. */
void *redcc_memory_resize(void *block, size_t bytes);

/** Frees a block; NULL does nothing. */
void redcc_memory_free(void *block);

/** Must be called in a forked process. At the fork, other threads of the parent may have been
 * allocating. */
void redcc_memory_forked(void);

/** The number of bytes that a block occupies, including its header; 0 for NULL. */
size_t redcc_memory_size(const void *block);

/** Limits the total memory to `bytes` from now on; 0: no limit. */
void redcc_memory_limit(size_t bytes);

/** Sets whether allocations of the calling thread are exempt from the limit. The limit is meant for
 * plans and copies; other memory, such as a loop's row in the report, is exempt. */
void redcc_memory_exempt(bool owed);

/** For tests: after `calls_from_now` more allocations, all fail. Negative: none fails. */
void redcc_memory_fail_after(long calls_from_now);

/** Has redcc_memory_fail_after taken effect, so that every allocation fails? */
bool redcc_memory_is_exhausted(void);

/** The number of allocated blocks. */
long redcc_memory_live(void);

/** The number of allocated bytes. */
size_t redcc_memory_in_use(void);

#endif
