/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ownership/graph/levels.h"

#include "base/memory.h"
#include "base/share.h"

#include <assert.h>

enum { FEW = 64 }; /* a level of fewer iterations is executed by one thread */

/* The cost of a barrier, in units of an iteration's time: a barrier takes some 2 microseconds, a
 * short iteration 10 nanoseconds. */
static const double barrier_length = 200;

static const uint32_t left_out = UINT32_MAX;

/* State while levels are computed. */
struct levelling {
    uint32_t *level; /* [trip] the level of each iteration, or left_out */
    uint32_t *free;  /* [units] for each unit, the first level whose iterations may touch it */
    uint32_t *size;  /* [levels] number of iterations of each level */
    uint32_t *stage; /* [levels] stage of each level */
    uint32_t levels;
    uint32_t units;
    uint32_t trip;
};

static uint32_t highest(const struct levelling *it, struct access_log_reader reading,
                        uint32_t level) {
    for (bool last = false; !last;) {
        const uint32_t unit = redcc_access_log_read(&reading, &last);
        if (unit != REDCC_NO_UNIT && it->free[unit] > level)
            level = it->free[unit];
    }
    return level;
}

/* Marks the iteration's units as occupied up to `level`. Returns whether the iteration has any
 * units. */
static bool occupy(struct levelling *it, struct access_log_reader *reading, uint32_t level) {
    bool any = false;
    for (bool last = false; !last;) {
        const uint32_t unit = redcc_access_log_read(reading, &last);
        if (unit == REDCC_NO_UNIT)
            continue;
        it->free[unit] = level + 1;
        any = true;
    }
    return any;
}

static void find_levels(struct levelling *it, const struct access_log *logged, int threads,
                        bool every) {
    uint32_t t = 0;
    for (int thread = 0; thread < threads; thread++) {
        struct access_log_reader leading = {&logged[thread].leading, 0};
        struct access_log_reader further = {&logged[thread].further, 0};
        for (redcc_int i = 0; i < logged[thread].iterations; i++, t++) {
            uint32_t level = highest(it, leading, 0);
            if (further.list->count)
                level = highest(it, further, level);
            bool any = occupy(it, &leading, level);
            if (further.list->count)
                any = occupy(it, &further, level) || any;
            const bool idle = !any && !every && t + 1 < it->trip;
            it->level[t] = idle ? left_out : level;
            if (!idle && level >= it->levels)
                it->levels = level + 1;
        }
    }
}

/* Assigns levels to stages. Consecutive levels that all have few iterations share a stage. Returns
 * the number of stages. */
static uint32_t find_stages(struct levelling *it) {
    uint32_t stages = 0;
    for (uint32_t t = 0; t < it->trip; t++)
        if (it->level[t] != left_out)
            it->size[it->level[t]]++;
    for (uint32_t level = 0; level < it->levels; level++) {
        const bool joins = level > 0 && it->size[level] < FEW && it->size[level - 1] < FEW;
        stages += !joins;
        it->stage[level] = stages - 1;
    }
    return stages;
}

static void put_in_stages(const struct levelling *it, struct levels *levels) {
    struct level_stage *stage = levels->stage;
    for (uint32_t level = 0; level < it->levels; level++) {
        stage[it->stage[level] + 1].begin += it->size[level];
        stage[it->stage[level]].alone = it->size[level] < FEW;
    }
    for (uint32_t s = 0; s < levels->stages; s++)
        stage[s + 1].begin += stage[s].begin;
    for (uint32_t t = 0; t < it->trip; t++)
        if (it->level[t] != left_out)
            levels->iteration[stage[it->stage[it->level[t]]].begin++] = t;
    for (uint32_t s = levels->stages; s > 0;
         s--) /* each `begin` has advanced to that of the next stage */
        stage[s].begin = stage[s - 1].begin;
    stage[0].begin = 0;
    levels->count = stage[levels->stages].begin;
    assert(levels->count <= it->trip);
}

static bool make(struct levelling *it, struct levels *levels, const struct access_log *logged,
                 int threads, bool every) {
    it->level = redcc_memory_alloc(it->trip * sizeof *it->level);
    it->free = redcc_memory_alloc_zeroed(it->units, sizeof *it->free);
    if (!it->level || !it->free)
        return false;
    find_levels(it, logged, threads, every);
    it->size = redcc_memory_alloc_zeroed(it->levels, sizeof *it->size);
    it->stage = redcc_memory_alloc(it->levels * sizeof *it->stage);
    if (!it->size || !it->stage)
        return false;
    levels->levels = it->levels;
    levels->stages = find_stages(it);
    levels->stage = redcc_memory_alloc_zeroed((size_t)levels->stages + 1, sizeof *levels->stage);
    levels->iteration = redcc_memory_alloc(it->trip * sizeof *levels->iteration);
    if (!levels->stage || !levels->iteration)
        return false;
    put_in_stages(it, levels);
    return true;
}

bool redcc_levels_begin(struct levels *levels, const struct access_log *logged, int threads,
                        bool every) {
    assert(threads >= 1);
    *levels = (struct levels){0};
    struct levelling it = {.units = logged->units};
    for (int thread = 0; thread < threads; thread++)
        it.trip += (uint32_t)logged[thread].iterations;
    const bool made = make(&it, levels, logged, threads, every);
    redcc_memory_free(it.level);
    redcc_memory_free(it.free);
    redcc_memory_free(it.size);
    redcc_memory_free(it.stage);
    return made;
}

void redcc_levels_end(struct levels *levels) {
    redcc_memory_free(levels->iteration);
    redcc_memory_free(levels->stage);
    *levels = (struct levels){0};
}

void redcc_levels_share(const struct levels *levels, uint32_t stage, int threads, int thread,
                        uint32_t *first, uint32_t *end) {
    assert(stage < levels->stages && 0 <= thread && thread < threads);
    const uint32_t begin = levels->stage[stage].begin;
    const uint32_t count = levels->stage[stage + 1].begin - begin;
    if (levels->stage[stage].alone) {
        *first = begin;
        *end = thread == 0 ? begin + count : begin;
        return;
    }
    *first = begin + redcc_part_first(count, threads, thread);
    *end = begin + redcc_part_first(count, threads, thread + 1);
}

double redcc_levels_length(const struct levels *levels, int threads) {
    assert(threads >= 1);
    double length = 0;
    for (uint32_t s = 0; s < levels->stages; s++) {
        const uint32_t count = levels->stage[s + 1].begin - levels->stage[s].begin;
        length += barrier_length;
        length += levels->stage[s].alone ? (double)count : (double)count / threads;
    }
    return length;
}
