/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/memory.h"

#include "base/blocks.h"

#include <assert.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { LINE = 64 };

/* The header of a block. It occupies the cache line before the block. */
struct header {
    size_t bytes; /* bytes counted against the limit */
    size_t held;  /* size of the underlying memory, which may be larger */
    bool kept;    /* the memory may be cached when it is freed */
};

#if defined(__SANITIZE_ADDRESS__) /* each block is a separate allocation of the sanitizer's        \
                                   * malloc, so that accesses beyond its end are detected */
static void *block_alloc(size_t *bytes, bool keep) {
    (void)keep;
    return aligned_alloc(LINE, *bytes);
}

static void block_free(void *block, size_t bytes, bool keep) {
    (void)bytes;
    (void)keep;
    free(block);
}
#else
#define block_alloc redcc_block_alloc
#define block_free redcc_block_free
#endif

static atomic_size_t in_use;
static atomic_size_t limit;         /* 0: no limit */
static _Thread_local bool is_exempt /* exempt from the limit */
    __attribute__((__tls_model__("initial-exec")));
static atomic_long live;
static atomic_long until_failure = -1;

static bool fails_on_purpose(void) {
    if (atomic_load_explicit(&until_failure, memory_order_relaxed) < 0)
        return false;
    long left = atomic_load(&until_failure);
    while (left > 0)
        if (atomic_compare_exchange_weak(&until_failure, &left, left - 1))
            return false;
    return left == 0;
}

static bool account(size_t bytes) {
    size_t most = atomic_load_explicit(&limit, memory_order_relaxed);
    size_t before = atomic_fetch_add(&in_use, bytes);
    if (most && before + bytes > most && !is_exempt) {
        atomic_fetch_sub(&in_use, bytes);
        return false;
    }
    return true;
}

void *redcc_memory_alloc(size_t bytes) {
    if (bytes > SIZE_MAX / 2 || fails_on_purpose())
        return NULL;
    const size_t whole = (bytes + LINE - 1) / LINE * LINE + LINE;
    if (!account(whole))
        return NULL;
    const bool keep = atomic_load_explicit(&limit, memory_order_relaxed) == 0;
    size_t held = whole;
    char *memory = block_alloc(&held, keep);
    if (!memory) {
        atomic_fetch_sub(&in_use, whole);
        return NULL;
    }
    assert(held >= whole && (uintptr_t)memory % LINE == 0);
    *(struct header *)memory = (struct header){whole, held, keep};
    atomic_fetch_add(&live, 1);
    return memory + LINE;
}

void *redcc_memory_alloc_zeroed(size_t count, size_t size) {
    if (size && count > SIZE_MAX / 2 / size)
        return NULL;
    void *block = redcc_memory_alloc(count * size);
    if (block)
        memset(block, 0, count * size);
    return block;
}

static struct header *header_of(const void *block) {
    return (struct header *)((uintptr_t)block - LINE);
}

char *redcc_memory_copy_text(const char *text) {
    const size_t bytes = strlen(text) + 1;
    char *copy = redcc_memory_alloc(bytes);
    return copy ? memcpy(copy, text, bytes) : NULL;
}

void *redcc_memory_resize(void *block, size_t bytes) {
    void *other = redcc_memory_alloc(bytes);
    if (other && block) {
        const size_t held = redcc_memory_size(block) - LINE;
        assert(held > 0);
        memcpy(other, block, held < bytes ? held : bytes);
        redcc_memory_free(block);
    }
    return other;
}

void redcc_memory_free(void *block) {
    if (!block)
        return;
    assert(header_of(block)->bytes >= LINE && header_of(block)->bytes <= header_of(block)->held);
    assert(atomic_load(&in_use) >= header_of(block)->bytes && atomic_load(&live) > 0);
    atomic_fetch_sub(&in_use, header_of(block)->bytes);
    atomic_fetch_sub(&live, 1);
    const struct header header = *header_of(block);
    block_free(header_of(block), header.held, header.kept);
}

void redcc_memory_forked(void) {
    redcc_blocks_forked();
}

size_t redcc_memory_size(const void *block) {
    return block ? header_of(block)->bytes : 0;
}

void redcc_memory_limit(size_t bytes) {
    atomic_store(&limit, bytes);
}

void redcc_memory_exempt(bool owed) {
    is_exempt = owed;
}

void redcc_memory_fail_after(long calls_from_now) {
    atomic_store(&until_failure, calls_from_now);
}

bool redcc_memory_is_exhausted(void) {
    return atomic_load(&until_failure) == 0;
}

long redcc_memory_live(void) {
    return atomic_load(&live);
}

size_t redcc_memory_in_use(void) {
    return atomic_load(&in_use);
}
