/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * LOCALWRITE: each thread owns a part of the arrays and executes, in ascending order, every
 * iteration that writes to its part. If an iteration writes to the parts of several owners, each of
 * them executes it, in the owner-checked form, which writes only the thread's own elements.
 *
 * Each element gets its contributions in the order of the loop, so the result has the bits of the
 * sequential loop.
 */
#include "plan/methods/localwrite.h"

#include <assert.h>

#include "base/memory.h"

enum { SKIP, PLAIN, CHECKED };

/* [sets->count] for each set of owners, the form in which `owner` executes the iterations that
 * touch this set: SKIP, PLAIN or CHECKED. NULL: out of memory. */
static unsigned char *parts_in(const struct sets *sets, uint32_t owner) {
    unsigned char *part = redcc_memory_alloc_zeroed(sets->count, 1);
    if (!part)
        return NULL;
    for (uint32_t set = 1; set < sets->count; set++)
        for (size_t m = sets->start[set]; m < sets->start[set + 1]; m++)
            if (sets->member[m] == owner)
                part[set] = redcc_set_size(sets, set) == 1 ? PLAIN : CHECKED;
    return part;
}

/* Counts the iterations that the owner executes in each form. */
static void count_parts(const struct summary *summary, const unsigned char *part,
                        redcc_int *amount) {
    for (size_t b = 0; b < summary->block_count; b++) {
        const struct block *block = &summary->block[b];
        for (size_t s = block->span_begin; s < block->span_end; s++)
            amount[part[summary->span[s].set]] += redcc_span_count(summary, block, s);
    }
}

/* If most of the owner's iterations in a summary are owner-checked, makes all of them
 * owner-checked: longer runs gain more than the checks cost. */
static void check_most(const struct summary *summary, unsigned char *part) {
    redcc_int amount[CHECKED + 1] = {0};
    count_parts(summary, part, amount);
    for (uint32_t set = 0; amount[CHECKED] > amount[PLAIN] && set < summary->sets.count; set++)
        if (part[set] == PLAIN)
            part[set] = CHECKED;
}

static bool select_from(struct schedule *schedule, const struct summary *summary, uint32_t owner,
                        bool takes_idle) {
    unsigned char *part = parts_in(&summary->sets, owner);
    bool enough = part != NULL;
    if (enough && takes_idle)
        part[0] = PLAIN; /* set 0: iterations that touch nothing. The thread that inspected them
                            executes them */
    if (enough)
        check_most(summary, part);
    for (size_t b = 0; enough && b < summary->block_count; b++) {
        const struct block *block = &summary->block[b];
        for (size_t s = block->span_begin; enough && s < block->span_end; s++) {
            const struct span span = summary->span[s];
            if (part[span.set] != SKIP)
                enough =
                    redcc_schedule_add(schedule, 0, block->origin + span.begin,
                                       redcc_span_count(summary, block, s), part[span.set] - PLAIN);
        }
    }
    redcc_memory_free(part);
    return enough;
}

bool redcc_localwrite_select(struct plan *plan, const struct evidence *evidence, uint32_t owner,
                             int idle_of) {
    assert(owner < plan->schedules && idle_of < evidence->threads);
    struct schedule *schedule = &plan->schedule[owner];
    for (int from = 0; from < evidence->threads; from++)
        if (!select_from(schedule, evidence->summary[from], owner,
                         evidence->every_iteration && from == idle_of))
            return false;
    if (!evidence->every_iteration && idle_of == evidence->threads - 1 &&
        redcc_last_touches_nothing(evidence) &&
        !redcc_schedule_add(schedule, 0, evidence->trip - 1, 1, false))
        return false;
    redcc_schedule_finish(schedule);
    return true;
}

bool redcc_localwrite_prepare(struct plan *plan, const struct evidence *evidence, int thread) {
    return redcc_localwrite_select(plan, evidence, (uint32_t)thread, thread);
}

const struct method redcc_method_localwrite = {
    .name = "localwrite", .keeps = REDCC_ORDER_SERIAL, .prepare = redcc_localwrite_prepare};
