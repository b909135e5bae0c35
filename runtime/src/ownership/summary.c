/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ownership/summary.h"

#include "base/memory.h"

#include <assert.h>

bool redcc_summary_begin(struct summary *summary, uint32_t owners) {
    assert(owners >= 1);
    *summary = (struct summary){.span_capacity = 512, .block_capacity = 4};
    summary->span = redcc_memory_alloc(summary->span_capacity * sizeof *summary->span);
    summary->block = redcc_memory_alloc(summary->block_capacity * sizeof *summary->block);
    return redcc_sets_begin(&summary->sets, owners) && summary->span && summary->block;
}

void redcc_summary_end(struct summary *summary) {
    redcc_sets_end(&summary->sets);
    redcc_memory_free(summary->span);
    redcc_memory_free(summary->block);
    *summary = (struct summary){0};
}

bool redcc_summary_open_block(struct summary *summary, redcc_int origin) {
    assert(origin >= 0 && summary->block_count <= summary->block_capacity);
    if (summary->block_count == summary->block_capacity) {
        const size_t more = summary->block_capacity * 2;
        struct block *block = redcc_memory_resize(summary->block, more * sizeof *block);
        if (!block)
            return false;
        summary->block = block;
        summary->block_capacity = more;
    }
    summary->block[summary->block_count++] =
        (struct block){origin, 0, summary->span_count, summary->span_count};
    return true;
}

bool redcc_summary_add(struct summary *summary, uint32_t set, redcc_int count) {
    assert(summary->block_count > 0 && count >= 1 && set < summary->sets.count);
    struct block *block = &summary->block[summary->block_count - 1];
    assert(count <= REDCC_BLOCK - block->count);
    if (block->span_end > block->span_begin && summary->span[block->span_end - 1].set == set) {
        block->count += count;
        return true;
    }
    if (summary->span_count == summary->span_capacity) {
        const size_t more = summary->span_capacity * 2;
        struct span *span = redcc_memory_resize(summary->span, more * sizeof *span);
        if (!span)
            return false;
        summary->span = span;
        summary->span_capacity = more;
    }
    summary->span[summary->span_count++] = (struct span){(uint32_t)block->count, set};
    block->span_end = summary->span_count;
    block->count += count;
    return true;
}
