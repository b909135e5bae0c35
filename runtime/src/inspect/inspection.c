/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "inspect/inspection.h"

#include "base/clock.h"
#include "base/memory.h"
#include "plan/method.h"

#include <assert.h>

enum { LEAST_TRIP_TO_STEAL = 4096 };

void redcc_inspection_set_owners(struct inspection *inspection) {
    const struct call *call = inspection->call;
    assert(call->planned >= 1);
    const uint32_t each = 1 + inspection->stealable;
    inspection->partition.stealable = inspection->stealable;
    inspection->partition.owners = call->method && call->method->owners
                                       ? call->method->owners(call->planned, call->parameter)
                                       : (uint32_t)call->planned * each;
}

/* The maximum number of owners for which memory is needed. With auto it includes stealable blocks,
 * because auto may add them after the cut. */
static uint32_t most_owners(const struct call *call) {
    const uint32_t threads = (uint32_t)call->planned;
    if (!call->method)
        return threads * (1 + REDCC_STEALABLE);
    if (call->method->owners)
        return call->method->owners(call->planned, call->parameter);
    return threads * (call->method->steals ? 1 + REDCC_STEALABLE : 1);
}

/* Begins a partition. If threads find their iterations during execution, keeps the owners of an
 * earlier execution, because the result does not depend on the owners. */
static bool begin_partition(struct inspection *inspection, bool is_direct) {
    const struct call *call = inspection->call;
    struct partition *partition = &inspection->partition;
    if (partition->share > 0 && is_direct && partition->owners == (uint32_t)call->planned) {
        redcc_partition_move(partition, call->request.bases);
        return true;
    }
    redcc_partition_end(partition);
    const bool begun = redcc_partition_begin(partition, call->request.loop, call->request.bases,
                                             most_owners(call));
    if (begun)
        redcc_inspection_set_owners(inspection);
    return begun;
}

bool redcc_inspection_begin(struct inspection *inspection, bool is_direct) {
    const struct call *call = inspection->call;
    const size_t threads = (size_t)call->threads;
    assert(threads >= 1 && call->request.trip > 0);
    const bool cuts_blocks = call->method ? call->method->steals
                                          : !is_direct && call->request.trip >= LEAST_TRIP_TO_STEAL;
    inspection->stealable = cuts_blocks ? REDCC_STEALABLE : 0;
    inspection->route = ROUTE_OWNERS;
    inspection->no_copies = inspection->no_graph = false;
    inspection->samples = redcc_memory_alloc(threads * sizeof *inspection->samples);
    inspection->summaries = redcc_memory_alloc(threads * sizeof *inspection->summaries);
    inspection->seen = redcc_memory_alloc(threads * sizeof *inspection->seen);
    inspection->whole = (struct partition){0};
    if (!begin_partition(inspection, is_direct))
        return false;
    assert(inspection->partition.owners <= inspection->partition.room);
    return inspection->samples && inspection->summaries && inspection->seen;
}

void redcc_inspection_end(struct inspection *inspection) {
    for (int thread = 0; thread < inspection->call->threads; thread++) {
        struct inspector *inspector = inspection->inspector[thread];
        redcc_sample_end(&inspector->sample);
        redcc_sweep_end(&inspector->sweep);
        redcc_memory_free(inspector->entries);
        redcc_memory_free(inspector->seen);
        redcc_memory_free(inspector->executed);
        inspector->entries = NULL;
        inspector->seen = NULL;
        inspector->executed = NULL;
    }
    redcc_divide_end(&inspection->divide);
    redcc_levels_end(&inspection->levels);
    redcc_memory_free(inspection->whole.cut); /* inspection->partition owns its other memory */
    inspection->whole = (struct partition){0};
    if (inspection->partition.share == 0)
        redcc_partition_end(&inspection->partition);
    redcc_memory_free(inspection->samples);
    redcc_memory_free(inspection->summaries);
    redcc_memory_free(inspection->seen);
    inspection->samples = NULL;
    inspection->summaries = NULL;
    inspection->seen = NULL;
}

bool redcc_inspection_is_late(const struct inspection *inspection) {
    return inspection->pace.deadline > 0 && redcc_seconds() > inspection->pace.deadline;
}

bool redcc_inspection_will_be_late(const struct inspection *inspection, double done) {
    if (inspection->pace.deadline == 0)
        return false;
    const double now = redcc_seconds(), left = inspection->pace.deadline - now;
    const double spent = now - inspection->pace.began;
    return left < 0 || (15 * spent > left && spent * (1 - done) > left * done);
}

bool redcc_inspection_failed(const struct inspection *inspection) {
    for (int thread = 0; thread < inspection->call->threads; thread++)
        if (inspection->inspector[thread]->failed)
            return true;
    return false;
}

redcc_int redcc_own_begin(const struct inspection *inspection, const struct inspector *inspector) {
    assert(0 <= inspector->thread && inspector->thread < inspector->threads);
    return redcc_share(inspection->call->request.trip, inspector->threads, inspector->thread);
}

redcc_int redcc_own_end(const struct inspection *inspection, const struct inspector *inspector) {
    return redcc_share(inspection->call->request.trip, inspector->threads, inspector->thread + 1);
}

void redcc_hand_out(struct inspector *inspector, redcc_worker *worker, redcc_int first,
                    redcc_int last, redcc_int stride, const redcc_owner *window) {
    assert(0 <= first && first < last && last <= worker->call->trip && stride > 0);
    worker->first = first;
    worker->last = last;
    worker->stride = stride;
    worker->sources = inspector->sources;
    worker->window = window;
    worker->inside = worker->outside = 0;
    worker->alike = 0;
    worker->entry = inspector->entries;
    worker->entry_end = inspector->entries + REDCC_ENTRIES;
}

void redcc_forget_sources(const struct inspection *inspection, struct inspector *inspector) {
    for (uint32_t s = 0; s < inspection->call->request.loop->source_count; s++)
        inspector->sources[s] = (redcc_extent){0, 0};
}

void redcc_gather_touched(struct inspection *inspection) {
    for (uint32_t group = 0; group < inspection->partition.array_count; group++) {
        struct range touched = redcc_nowhere;
        for (int thread = 0; thread < inspection->call->threads; thread++)
            touched = redcc_range_union(touched, inspection->inspector[thread]->seen[group]);
        inspection->touched[group] = touched;
    }
}
