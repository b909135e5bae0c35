/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The access summary: the iterations that one thread inspected, in order, as spans of consecutive
 * iterations that touch the same set of owners. Most methods need only the summary to build a plan;
 * struct evidence (plan/method.h) has all that they get.
 */
#ifndef REDCC_SUMMARY_H
#define REDCC_SUMMARY_H

#include "ownership/partition.h"

#include "ownership/sets.h"
#include <assert.h>

/** A span: iterations that touch the same set of owners. They are numbered from `begin`, relative
 * to the block's origin, to before the next span's `begin`. */
struct span {
    uint32_t begin;
    uint32_t set;
};

/** A block of at most 2^30 consecutive iterations. */
struct block {
    redcc_int origin;
    redcc_int count;
    size_t span_begin;
    size_t span_end;
};

enum { REDCC_BLOCK = 1 << 30 };

struct summary {
    struct sets sets;
    struct span *span;
    size_t span_count;
    size_t span_capacity;
    struct block *block;
    size_t block_count;
    size_t block_capacity;
};

/** Makes an empty summary for `owners` owners. False: out of memory. Call redcc_summary_end in
 * either case. */
bool redcc_summary_begin(struct summary *summary, uint32_t owners);

/** Frees the summary's memory. */
void redcc_summary_end(struct summary *summary);

/** Begins a block whose first iteration is number `origin`. Returns false if out of memory. */
bool redcc_summary_open_block(struct summary *summary, redcc_int origin);

/** Adds the block's next `count` >= 1 iterations, which touch `set`. False: out of memory. */
bool redcc_summary_add(struct summary *summary, uint32_t set, redcc_int count);

static inline redcc_int redcc_span_count(const struct summary *summary, const struct block *block,
                                         size_t span) {
    assert(block->span_begin <= span && span < block->span_end);
    const redcc_int end = span + 1 < block->span_end ? summary->span[span + 1].begin : block->count;
    assert(end > summary->span[span].begin);
    return end - summary->span[span].begin;
}

#endif
