/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * An allocator. Block sizes fall into classes, four per power of two, so that freed blocks can be
 * reused. Small blocks are cut from pieces of memory that are never unmapped. Large blocks are
 * separate mappings; some of them are cached, which avoids new page faults. If the lock is
 * unavailable, as in a signal handler that interrupted its holder, a block is a separate mapping.
 */
#include "base/blocks.h"

#include <assert.h>

#include "base/spin.h"

enum {
    LINE = 64,
    PER_DOUBLING = 4,
    CLASSES = 34 * PER_DOUBLING, /* larger blocks are mapped and unmapped each time */
    SMALL_MOST = 64 * 1024,      /* maximum size of a small block in bytes */
    PIECE = 1024 * 1024,
    LARGE_KEPT = 64 * 1024 * 1024
};

struct free_block {
    struct free_block *next;
};

static struct spin lock;
static struct free_block *free_blocks[CLASSES];
static char *piece; /* the unused rest of the memory from which small blocks are cut */
static size_t piece_left;
static size_t kept; /* total bytes of cached large blocks */

/* The size class of `bytes` > 0 bytes. Sets *size to the size of the class's blocks. */
static unsigned class_of(size_t bytes, size_t *size) {
    const size_t lines = (bytes + LINE - 1) / LINE;
    unsigned doublings = 0;
    while (lines > (size_t)2 * PER_DOUBLING << doublings)
        doublings++;
    const size_t step = (size_t)1 << doublings;
    const size_t steps = (lines + step - 1) / step; /* at most 2 * PER_DOUBLING */
    *size = steps * step * LINE;
    assert(lines > 0 && *size >= bytes && steps <= (size_t)2 * PER_DOUBLING);
    return doublings * PER_DOUBLING + (unsigned)steps - 1;
}

static size_t whole_pages(size_t bytes) {
    const size_t page = redcc_page_size();
    return (bytes + page - 1) / page * page;
}

/* Cuts a small block from the piece. If the rest of the piece is too small for the block, abandons
 * the rest: this wastes less than a sixteenth of the piece. */
static void *cut(size_t bytes) {
    if (piece_left < bytes) {
        char *more = redcc_system_map(PIECE);
        if (!more)
            return NULL;
        piece = more;
        piece_left = PIECE;
    }
    assert(bytes % LINE == 0 && bytes <= piece_left);
    void *block = piece;
    piece += bytes;
    piece_left -= bytes;
    return block;
}

static void *take_free(unsigned class, size_t bytes) {
    struct free_block *block = free_blocks[class];
    if (!block)
        return NULL;
    free_blocks[class] = block->next;
    assert(bytes <= SMALL_MOST || bytes <= kept);
    kept -= bytes > SMALL_MOST ? bytes : 0;
    return block;
}

void *redcc_block_alloc(size_t *bytes, bool keep) {
    size_t size;
    const unsigned class = class_of(*bytes, &size);
    const bool small = size <= SMALL_MOST;
    if (!small && (!keep || class >= CLASSES)) {
        *bytes = whole_pages(*bytes);
        return redcc_system_map(*bytes);
    }
    *bytes = small ? size : whole_pages(size);
    if (!redcc_spin_hope(&lock))
        return redcc_system_map(whole_pages(*bytes));
    void *block = take_free(class, *bytes);
    if (!block && small)
        block = cut(size);
    redcc_spin_unlock(&lock);
    return block || small ? block : redcc_system_map(*bytes);
}

/* Adds a block to the free blocks. False: the caller must unmap it. */
static bool put(void *block, size_t bytes, bool keep) {
    size_t size;
    const unsigned class = class_of(bytes, &size);
    const bool small = bytes <= SMALL_MOST;
    if (!small && (!keep || class >= CLASSES || size != bytes))
        return false;
    if (!redcc_spin_hope(&lock))
        return small; /* without the lock, a small block is never used again */
    const bool stays = small || kept + bytes <= LARGE_KEPT;
    if (stays) {
        struct free_block *free_block = block;
        free_block->next = free_blocks[class];
        free_blocks[class] = free_block;
        kept += small ? 0 : bytes;
    }
    redcc_spin_unlock(&lock);
    return stays;
}

void redcc_block_free(void *block, size_t bytes, bool keep) {
    if (!put(block, bytes, keep))
        redcc_system_unmap(block, bytes);
}

void redcc_blocks_forked(void) {
    for (int class = 0; class < CLASSES; class ++)
        free_blocks[class] = NULL;
    piece_left = kept = 0;
    redcc_spin_unlock(&lock);
}
