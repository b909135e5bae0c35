/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * All memory of the runtime: counted, limited by REDCC_MEMORY_LIMIT, and made to fail by tests.
 * None of it is the program's malloc's (blocks.h). Every function is thread-safe.
 */
#ifndef REDCC_MEMORY_H
#define REDCC_MEMORY_H

#include <stdbool.h>
#include <stddef.h>

/** `bytes` bytes, aligned to a cache line, not initialised (so that the thread that writes a page
 *  first decides where it lies); NULL where there are none left or the limit would be passed. */
void *redcc_memory_take(size_t bytes);

/** As redcc_memory_take, for `count` items of `size` bytes, all zero. */
void *redcc_memory_take_zeroed(size_t count, size_t size);

/** A copy of the text; NULL where there is no memory. */
char *redcc_memory_take_text(const char *text);

/** A block of another size with the contents of `block` (NULL: an empty one), which is given back;
 *  NULL: `block` stays as it was. */
void *redcc_memory_resize(void *block, size_t bytes);

/** Gives a block back; NULL does nothing. */
void redcc_memory_give(void *block);

/** To be called in a new process: other threads of the one before may have been taking memory. */
void redcc_memory_forked(void);

/** Bytes a block takes; 0 for NULL. */
size_t redcc_memory_size(const void *block);

/** From now on no more than `bytes` may be taken in all; 0: as much as there is. */
void redcc_memory_limit(size_t bytes);

/** From now on blocks that the calling thread takes may pass the limit: true for what is no plan
 * and no copy, a loop's row in the report. */
void redcc_memory_owe(bool owed);

/** For tests: the `calls_from_now`-th take fails and so do those after it (0: the very next;
 *  negative: none). */
void redcc_memory_fail_after(long calls_from_now);

/** Has redcc_memory_fail_after come to its end, so that every take fails? */
bool redcc_memory_is_exhausted(void);

/** Blocks taken and not given back. */
long redcc_memory_live(void);

/** Bytes taken and not given back. */
size_t redcc_memory_in_use(void);

#endif
