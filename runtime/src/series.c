/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Operands that inner loops add to floating scalars; an iteration may have any number of them
 * (redcc/series.h). Several threads may execute an iteration, each for its own elements. Each of
 * these threads then stores all operands of the iteration, or none. So it does not matter which of
 * them is the last to store its part.
 *
 * If memory runs out during the loop, the original loop cannot run, because the arrays are already
 * written. But only operands are lost, and they do not depend on the loop's updates: executing all
 * iterations again, without owning any element, reproduces them. The same is done if an iteration
 * leaves a fence (ownership/fences.h), because the operands of later iterations may depend on
 * updates.
 */
#include "series.h"

#include "base/forked.h"
#include "base/memory.h"
#include "execute/run.h"
#include "loop.h"
#include "operands.h"

#include <assert.h>

enum {
    BLOCK_OPERANDS = 8192 - 8, /* an operand_block with its pointers takes less than 64 KiB */
    /* size of a part's head, in operands */
    HEAD = offsetof(redcc_series_part, value) / sizeof(double)
};

/* A block of memory for operands; written by one thread. */
struct operand_block {
    struct operand_block *next; /* the next block in the list of all blocks */
    struct operand_block *more; /* the next block in the list of the thread's blocks */
    double operand[BLOCK_OPERANDS];
};

struct redcc_series {
    _Atomic(struct operand_block *) blocks; /* list of all blocks */
    atomic_size_t bytes;                    /* total bytes of these blocks */
    size_t most;      /* limit of `bytes`, above which no block is allocated */
    atomic_bool lost; /* some operand was lost */
    redcc_int trip;
    _Atomic(redcc_series_part *) part[]; /* [trip] the first part of each iteration */
};

_Static_assert(offsetof(redcc_series_part, value) % sizeof(double) == 0,
               "parts lie among operands");

redcc_series *redcc_series_alloc(redcc_loop *loop, redcc_int trip) {
    if (trip <= 0)
        return NULL;
    (void)redcc_is_forked(); /* must precede any use of memory allocated by the parent process */
    const size_t most = redcc_operands_most_bytes();
    redcc_series *series = NULL;
    const size_t each = sizeof series->part[0];
    if ((redcc_size)trip <= (most - sizeof *series) / each)
        series = redcc_memory_alloc_zeroed(1, sizeof *series + (size_t)trip * each);
    if (!series) {
        redcc_note_no_memory(loop);
        return NULL;
    }
    series->trip = trip;
    series->most = most;
    return series;
}

void redcc_series_free(redcc_series *series) {
    struct operand_block *block = series ? series->blocks : NULL;
    while (block) {
        struct operand_block *next = block->next;
        redcc_memory_free(block);
        block = next;
    }
    redcc_memory_free(series);
}

void redcc_series_join(redcc_series_writer *writer, redcc_series *series) {
    *writer = (redcc_series_writer){.series = series};
}

/* Adds a block to the series. NULL: out of memory. */
static struct operand_block *new_block(redcc_series *series) {
    const size_t bytes = sizeof(struct operand_block);
    const size_t taken = atomic_fetch_add_explicit(&series->bytes, bytes, memory_order_relaxed);
    struct operand_block *block = taken <= series->most - bytes ? redcc_memory_alloc(bytes) : NULL;
    if (!block)
        return NULL;
    block->next = atomic_load_explicit(&series->blocks, memory_order_relaxed);
    while (!atomic_compare_exchange_weak_explicit(&series->blocks, &block->next, block,
                                                  memory_order_release, memory_order_relaxed))
        ;
    return block;
}

static void begin_block(redcc_series_writer *writer, struct operand_block *block) {
    writer->block = block;
    writer->at = block->operand;
    writer->block_end = block->operand + BLOCK_OPERANDS;
}

/* Switches to a block that an earlier band has used, or to a new one. False: out of memory. */
static bool next_block(redcc_series_writer *writer) {
    struct operand_block *block = writer->block ? writer->block->more : NULL;
    if (!block) {
        block = new_block(writer->series);
        if (!block)
            return false;
        block->more = NULL;
        *(writer->block ? &writer->block->more : &writer->first) = block;
    }
    begin_block(writer, block);
    return true;
}

int redcc_series_room(redcc_series_writer *writer, redcc_int k) {
    redcc_series *series = writer->series;
    assert(0 <= k && k < series->trip);
    if (writer->adds)
        return 0;
    REDCC_SERIES_COMPLETE(*writer);
    if (writer->block_end - writer->at <= HEAD && !next_block(writer)) {
        atomic_store_explicit(&series->lost, true, memory_order_relaxed);
        writer->block_end = writer->end = writer->at;
        return 0;
    }
    redcc_series_part *part = (redcc_series_part *)(void *)writer->at;
    part->more = NULL;
    if (writer->part)
        writer->part->more = part;
    else
        atomic_store_explicit(&series->part[k], part, memory_order_relaxed);
    writer->part = part;
    writer->begin = writer->at = part->value;
    writer->end = writer->block_end;
    return 1;
}

/* Was the loop executed by a plan, or in bins? All threads get the same answer. */
static bool is_executed(const struct thread_state *thread) {
    return thread &&
           (thread->stage == STAGE_RUN ||
            (thread->stage == STAGE_BINS && thread->execution->state->binning.round.begin > 0));
}

static bool any_is_lost(const redcc_series_writer *writers, redcc_u32 count) {
    for (redcc_u32 i = 0; i < count; i++)
        if (atomic_load_explicit(&writers[i].series->lost, memory_order_relaxed))
            return true;
    return false;
}

int redcc_series_repeats(redcc_worker *worker, redcc_series_writer *writers, redcc_u32 count) {
    assert(count > 0);
    struct thread_state *thread = worker->execution;
    for (redcc_u32 i = 0; i < count; i++)
        REDCC_SERIES_COMPLETE(writers[i]);
    if (!is_executed(thread))
        return 0;
    if (writers[0].adds && !writers[0].in_front)
        return redcc_run_again(worker);
    redcc_barrier_wait(thread->runner.run->barrier, thread->threads);
    const bool has_rest = redcc_run_has_rest(worker);
    if (thread->thread > 0 || !(has_rest || any_is_lost(writers, count)))
        return 0;
    for (redcc_u32 i = 0; i < count; i++) {
        writers[i].adds = 1;
        writers[i].begins = has_rest ? 2 : 1;
        writers[i].in_front = 0;
        writers[i].at = writers[i].end = writers[i].block_end = NULL;
    }
    redcc_run_own_nothing(worker);
    return redcc_run_again(worker);
}

int redcc_series_is_over(const redcc_worker *worker) {
    const struct thread_state *thread = worker->execution;
    return is_executed(thread) && thread->thread == 0;
}

const redcc_series_part *redcc_series_find(const redcc_series *series, redcc_int *k) {
    assert(*k >= 0);
    for (; *k < series->trip; ++*k) {
        redcc_series_part *part = atomic_load_explicit(&series->part[*k], memory_order_relaxed);
        if (part)
            return part;
    }
    return NULL;
}

int redcc_series_has_any(const redcc_series *series) {
    return atomic_load_explicit(&series->blocks, memory_order_relaxed) ||
           atomic_load_explicit(&series->lost, memory_order_relaxed);
}

void redcc_series_await_band(redcc_worker *worker) {
    struct thread_state *thread = worker->execution;
    redcc_tiles_await_sums(&thread->runner.tiles, thread->runner.plan);
}

const redcc_series_part *redcc_series_part_of(const redcc_series *series, redcc_int k) {
    assert(0 <= k && k < series->trip);
    return atomic_load_explicit(&series->part[k], memory_order_relaxed);
}

void redcc_series_end_band(redcc_worker *worker, redcc_series_writer *writers, redcc_u32 count) {
    const struct thread_state *thread = worker->execution;
    for (redcc_u32 i = 0; i < count; i++) {
        assert(!writers[i].begin);
        if (writers[i].first)
            begin_block(&writers[i], writers[i].first);
    }
    redcc_tiles_pass_sums(&thread->runner.tiles, thread->runner.plan);
}
