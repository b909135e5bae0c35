/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The dry run: does the loop update what decides where its slice reads? What was touched and what
 *  was read are ranges, as for the guard that follows. Where all that matters of what is read is
 *  known, a touch in the gap between two such ranges needs no other look. */
#include "inspect/inspection.h"

#include "base/memory.h"

#include <assert.h>

static const redcc_int never_settled = -((redcc_int)1 << 62); /* all are told, none is probed */

bool redcc_dry_run_start(const struct inspection *inspection, struct inspector *inspector) {
    const uint32_t arrays = inspection->partition.array_count;
    inspector->dry_run = (struct dry_run){
        .window = redcc_memory_take_zeroed(arrays, sizeof *inspector->dry_run.window)};
    inspector->entries = redcc_memory_take(REDCC_ENTRIES * sizeof *inspector->entries);
    inspector->failed = !inspector->dry_run.window || !inspector->entries;
    redcc_forget_sources(inspection, inspector);
    return !inspector->failed;
}

/* The next touch that no window holds is to be taken at once; an iteration's end comes after it. */
static void expect_one(const struct inspector *inspector, redcc_worker *worker) {
    worker->entry = inspector->entries;
    worker->entry_end = inspector->entries + 1;
    worker->inside = worker->outside = 0;
    worker->alike = never_settled;
}

void redcc_dry_run_hand_out(const struct inspection *inspection, struct inspector *inspector,
                            redcc_worker *worker) {
    redcc_hand_out(inspector, worker, 0, inspection->call->request.trip, 1,
                   inspector->dry_run.window);
    expect_one(inspector, worker);
    inspector->dry_run.stands = true;
}

/* Is all that matters of what is read known beforehand? */
static bool is_all_known(const struct inspection *inspection) {
    return !(inspection->call->request.loop->flags & REDCC_DRY_RUN_OF_READS);
}

/* Of a source, as far as it is known or, where that matters, told. */
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
    inspector->dry_run.stands = false;
    worker->last = 0;
}

/* The gap between what is known to be read that `touched` lies in. */
static struct range gap_around(const struct inspection *inspection, struct range touched) {
    const struct request *request = &inspection->call->request;
    struct range gap = {1, UINTPTR_MAX};
    for (uint32_t s = 0; s < request->loop->source_count; s++) {
        const struct range read = redcc_range_of(request->known[s]);
        if (redcc_range_empty(read))
            continue;
        if (read.end <= touched.first && read.end > gap.first)
            gap.first = read.end;
        if (read.first >= touched.end && read.first < gap.end)
            gap.end = read.first;
    }
    return gap;
}

static void take_touch(struct inspection *inspection, struct inspector *inspector,
                       redcc_worker *worker, const redcc_entry *entry) {
    redcc_owner *window = &inspector->dry_run.window[entry->array];
    const bool all_known = is_all_known(inspection);
    struct range touched = {(uintptr_t)entry->address, (uintptr_t)entry->address + entry->bytes};
    if (!all_known)
        touched = redcc_range_union(touched, range_of_window(window));
    for (uint32_t s = 0; s < inspection->call->request.loop->source_count; s++)
        if (redcc_ranges_overlap(range_read(inspection, inspector, s), touched)) {
            end_run(inspection, inspector, worker, (struct overlap){s, entry->array});
            return;
        }
    const struct range within = all_known ? gap_around(inspection, touched) : touched;
    *window = (redcc_owner){.first = (const char *)within.first, .size = within.end - within.first};
}

bool redcc_dry_run_is_stale(struct inspection *inspection, struct inspector *inspector,
                            redcc_worker *worker, uint32_t source) {
    const struct range read = range_read(inspection, inspector, source);
    for (uint32_t array = 0; array < inspection->partition.array_count; array++)
        if (redcc_ranges_overlap(read, range_of_window(&inspector->dry_run.window[array]))) {
            end_run(inspection, inspector, worker, (struct overlap){source, array});
            return true;
        }
    return false;
}

void redcc_dry_run_take(struct inspection *inspection, struct inspector *inspector,
                        redcc_worker *worker) {
    for (const redcc_entry *entry = inspector->entries; entry < worker->entry; entry++)
        if (worker->last > 0 && entry->array != REDCC_END_OF_ITERATION)
            take_touch(inspection, inspector, worker, entry);
    expect_one(inspector, worker);
}

enum reason redcc_dry_run_finish(struct inspection *inspection) {
    struct inspector *inspector = inspection->inspector[0];
    redcc_memory_give(inspector->dry_run.window);
    redcc_memory_give(inspector->entries);
    inspector->dry_run.window = NULL;
    inspector->entries = NULL;
    if (inspector->failed)
        return REASON_NO_MEMORY;
    return inspector->dry_run.stands ? REASON_NONE : REASON_OVERLAP;
}
