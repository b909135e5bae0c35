/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The dry run: does the loop update data that determine which addresses its slice reads? As in the
 * overlap guard, touched and read addresses are represented by ranges.
 *
 * To make the common case fast, each array has a window and each source a clear range, and no
 * window overlaps a clear range. So a touch in the array's window, or a read in the source's clear
 * range, needs no call of the runtime. If all relevant read ranges are known, a window is the gap
 * between two of them. Otherwise it is the touched range with a margin on each side. A margin is as
 * long as the range, but reaches at most halfway to the next read range. Clear ranges lie between
 * two windows. So a range that grows with each iteration is processed a logarithmic number of
 * times. A read in a margin need not overlap a touched address. If it ends the run, a second run
 * without margins follows.
 */
#include "inspect/inspection.h"

#include "base/clock.h"
#include "base/memory.h"
#include "ownership/overlap.h"

#include <assert.h>

/* Begins a run with the first iteration. Nothing is touched or read yet. */
static void begin_run(const struct inspection *inspection, struct inspector *inspector) {
    struct dry_run *run = &inspector->dry_run;
    for (uint32_t array = 0; array < inspection->partition.array_count; array++)
        run->window[array] = (redcc_owner){.size = 0};
    for (uint32_t s = 0; s < inspection->call->request.loop->source_count; s++)
        run->clear[s] = (redcc_owner){.size = 0};
    redcc_forget_sources(inspection, inspector);
    inspector->next = 0;
    inspector->late = false;
    run->block = REDCC_FIRST_BEFORE_DEADLINE;
    run->ended_in_margin = false;
    run->no_conflict = true;
    run->end = 0;
}

bool redcc_dry_run_start(const struct inspection *inspection, struct inspector *inspector) {
    assert(inspection->call->request.loop->flags & REDCC_DRY_RUN);
    const uint32_t arrays = inspection->partition.array_count;
    const uint32_t sources = inspection->call->request.loop->source_count;
    struct dry_run *run = &inspector->dry_run;
    *run = (struct dry_run){.window = redcc_memory_alloc(arrays * sizeof *run->window),
                            .clear = redcc_memory_alloc(sources * sizeof *run->clear),
                            .has_margins = true,
                            .usual = run->usual,
                            .seconds = -redcc_seconds()};
    inspector->entries = redcc_memory_alloc(REDCC_ENTRIES * sizeof *inspector->entries);
    inspector->failed = !run->window || !run->clear || !inspector->entries;
    if (!inspector->failed)
        begin_run(inspection, inspector);
    return !inspector->failed;
}

/* Are all relevant read ranges known beforehand? */
static bool is_all_known(const struct inspection *inspection) {
    return !(inspection->call->request.loop->flags & REDCC_DRY_RUN_OF_READS);
}

/* Leaves room for one touch and an iteration's end, so that the next touch outside of the windows
 * is processed immediately. */
static void expect_one(const struct inspection *inspection, const struct inspector *inspector,
                       redcc_worker *worker) {
    worker->entry = inspector->entries;
    worker->entry_end = inspector->entries + 1;
    worker->inside = worker->outside = 0;
    worker->alike = is_all_known(inspection) ? 2 * REDCC_DRY_PROBED : REDCC_DRY_PROBED / 2;
}

bool redcc_dry_run_hand_out(const struct inspection *inspection, struct inspector *inspector,
                            redcc_worker *worker) {
    struct dry_run *run = &inspector->dry_run;
    const redcc_int trip = inspection->call->request.trip;
    if (run->ended_in_margin) {
        run->has_margins = false;
        begin_run(inspection, inspector);
    }
    const redcc_int first = inspector->next;
    assert(0 <= first && first <= trip);
    if (!run->no_conflict || run->end > 0 || first == trip)
        return false;
    const double done = redcc_dry_run_done(inspection);
    inspector->late = redcc_inspection_will_be_late(inspection, done > 0 ? done : 1);
    if (inspector->late)
        return false;
    const bool at_once = inspection->pace.deadline == 0 || trip - first <= run->block;
    inspector->next = at_once ? trip : first + run->block;
    run->block = redcc_next_before_deadline(run->block);
    redcc_hand_out(inspector, worker, first, inspector->next, 1, run->window);
    worker->owner = run->clear;
    expect_one(inspection, inspector, worker);
    return true;
}

/* The range that is read of a source: the known one, or the recorded one if it is relevant. */
static struct range range_read(const struct inspection *inspection,
                               const struct inspector *inspector, uint32_t source) {
    const redcc_extent known = inspection->call->request.known[source];
    return redcc_range_of(known.end || is_all_known(inspection) ? known
                                                                : inspector->sources[source]);
}

static struct range range_of_window(const redcc_owner *window) {
    return window->size > 0
               ? (struct range){(uintptr_t)window->first, (uintptr_t)window->first + window->size}
               : redcc_nowhere;
}

static void end_run(struct inspection *inspection, struct inspector *inspector,
                    redcc_worker *worker, struct overlap overlap) {
    inspection->overlap = overlap;
    inspector->dry_run.no_conflict = false;
    worker->last = 0;
}

/* A range, and the free addresses around it, up to the nearest other ranges. */
struct gap {
    struct range range, free;
};

static struct gap gap_around(struct range range) {
    return (struct gap){range, {1, UINTPTR_MAX}};
}

static void bound_gap(struct gap *gap, struct range other) {
    if (redcc_range_empty(other))
        return;
    if (other.end <= gap->range.first && other.end > gap->free.first)
        gap->free.first = other.end;
    if (other.first >= gap->range.end && other.first < gap->free.end)
        gap->free.end = other.first;
}

static uintptr_t least(uintptr_t a, uintptr_t b) {
    return a < b ? a : b;
}

static struct range with_margin(const struct gap *gap) {
    const size_t size = redcc_range_size(gap->range);
    return (struct range){gap->range.first - least(size, (gap->range.first - gap->free.first) / 2),
                          gap->range.end + least(size, (gap->free.end - gap->range.end) / 2)};
}

static redcc_owner window_of(struct range range) {
    return (redcc_owner){.first = (const char *)range.first, .size = range.end - range.first};
}

/* Called after a window has grown: cuts the clear ranges that it overlaps. Each clear range keeps
 * the side that contains its source's read range. */
static void clear_of(struct inspection *inspection, struct inspector *inspector,
                     struct range window) {
    for (uint32_t s = 0; s < inspection->call->request.loop->source_count; s++) {
        redcc_owner *clear = &inspector->dry_run.clear[s];
        struct range range = range_of_window(clear);
        if (!redcc_ranges_overlap(range, window))
            continue;
        if (range_read(inspection, inspector, s).end <= window.first)
            range.end = window.first;
        else
            range.first = window.end;
        *clear = window_of(range);
    }
}

static void take_touch(struct inspection *inspection, struct inspector *inspector,
                       redcc_worker *worker, const redcc_entry *entry) {
    redcc_owner *window = &inspector->dry_run.window[entry->array];
    const bool all_known = is_all_known(inspection);
    struct range touched = {(uintptr_t)entry->address, (uintptr_t)entry->address + entry->bytes};
    if (!all_known)
        touched = redcc_range_union(touched, range_of_window(window));
    struct gap gap = gap_around(touched);
    for (uint32_t s = 0; s < inspection->call->request.loop->source_count; s++) {
        if (!redcc_source_meets_arrays(inspection->call->request.loop, s))
            continue;
        const struct range read = range_read(inspection, inspector, s);
        if (redcc_ranges_overlap(read, touched)) {
            end_run(inspection, inspector, worker, (struct overlap){s, entry->array});
            return;
        }
        bound_gap(&gap, read);
    }
    if (all_known)
        touched = gap.free;
    else if (inspector->dry_run.has_margins)
        touched = with_margin(&gap);
    *window = window_of(touched);
    if (!all_known)
        clear_of(inspection, inspector, touched);
}

bool redcc_dry_run_is_stale(struct inspection *inspection, struct inspector *inspector,
                            redcc_worker *worker, uint32_t source) {
    struct dry_run *run = &inspector->dry_run;
    if (source == REDCC_ENDS && worker->first > 0) {
        run->end = worker->call->trip = worker->first;
        worker->last = 0;
        return true;
    }
    if (source == REDCC_LEAVES || source == REDCC_ENDS) {
        run->leaves = true;
        end_run(inspection, inspector, worker, (struct overlap){0, 0});
        return true;
    }
    assert(source < inspection->call->request.loop->source_count);
    if (!redcc_source_meets_arrays(inspection->call->request.loop, source))
        return false;
    struct gap gap = gap_around(range_read(inspection, inspector, source));
    for (uint32_t array = 0; array < inspection->partition.array_count; array++) {
        const struct range window = range_of_window(&run->window[array]);
        if (redcc_ranges_overlap(gap.range, window)) {
            run->ended_in_margin = run->has_margins;
            end_run(inspection, inspector, worker, (struct overlap){source, array});
            return true;
        }
        bound_gap(&gap, window);
    }
    run->clear[source] = window_of(gap.free);
    return false;
}

void redcc_dry_run_take(struct inspection *inspection, struct inspector *inspector,
                        redcc_worker *worker) {
    for (const redcc_entry *entry = inspector->entries; entry < worker->entry; entry++)
        if (worker->last > 0 && entry->array != REDCC_END_OF_ITERATION)
            take_touch(inspection, inspector, worker, entry);
    expect_one(inspection, inspector, worker);
}

double redcc_dry_run_done(const struct inspection *inspection) {
    const struct request *request = &inspection->call->request;
    const bool may_end = request->loop->flags & REDCC_CONTINUES;
    const redcc_int next = inspection->inspector[0]->next;
    const redcc_int all = may_end ? inspection->inspector[0]->dry_run.usual : request->trip;
    return next < all ? (double)next / (double)all : may_end ? 0 : 1;
}

enum reason redcc_dry_run_finish(struct inspection *inspection, redcc_int *trip) {
    struct inspector *inspector = inspection->inspector[0];
    redcc_memory_free(inspector->dry_run.window);
    redcc_memory_free(inspector->dry_run.clear);
    redcc_memory_free(inspector->entries);
    inspector->dry_run.window = inspector->dry_run.clear = NULL;
    inspector->entries = NULL;
    inspector->dry_run.seconds += redcc_seconds();
    if (inspector->failed)
        return REASON_NO_MEMORY;
    if (inspector->late)
        return REASON_DEADLINE;
    if (inspector->dry_run.leaves)
        return REASON_LEAVES;
    if (!inspector->dry_run.no_conflict)
        return REASON_OVERLAP;
    *trip = inspector->dry_run.end > 0 ? inspector->dry_run.end : inspection->call->request.trip;
    inspector->dry_run.usual = *trip;
    return REASON_NONE;
}
