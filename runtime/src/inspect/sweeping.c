/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The sweep records the addresses of all iterations, block by block. From these it finds the exact
 * address ranges for the overlap guard. It also produces either access summaries for the owners
 * that were cut, or an access log (logging.c) from which owners or levels are computed. */
#include "inspect/inspection.h"

#include "base/aliases.h"
#include "base/share.h"

#include <assert.h>
#include <string.h>

enum { HASHED_AT_ONCE = 512 * 1024 /* number of bytes of subscripts that the caches hold */ };

/* The number of iterations per block. It is small enough that the subscripts of a block are still
 * in the caches when they are hashed. */
static redcc_int iterations_at_once(redcc_int own, size_t hashed) {
    const redcc_int blocks = (redcc_int)(hashed / HASHED_AT_ONCE) + 1;
    const redcc_int each = own / blocks + 1;
    return each < REDCC_BLOCK ? each : REDCC_BLOCK;
}

/* The partition by which iterations are summarised. If threads find their iterations during
 * execution, only address ranges are needed, so it has a single owner. */
static const struct partition *swept_by(const struct inspection *inspection) {
    return inspection->route == ROUTE_DIRECT ? &inspection->whole : &inspection->partition;
}

void redcc_sweep_start(const struct inspection *inspection, struct inspector *inspector,
                       size_t hashed) {
    const struct partition *partition = &inspection->partition;
    const redcc_int begin = redcc_own_begin(inspection, inspector);
    redcc_sweep_end(&inspector->sweep); /* a sweep is repeated if groups had to be merged */
    memset(inspector->executed, 0, partition->owners * sizeof *inspector->executed);
    inspector->failed =
        redcc_is_logged(inspection)
            ? !redcc_log_start(inspection, inspector)
            : !redcc_sweep_begin(&inspector->sweep, swept_by(inspection), inspector->seen);
    inspector->next = begin;
    inspector->handed = 0;
    inspector->block = iterations_at_once(redcc_own_end(inspection, inspector) - begin, hashed);
    inspector->largest = inspector->block;
    if (inspection->pace.deadline > 0 && inspector->block > REDCC_FIRST_BEFORE_DEADLINE)
        inspector->block = REDCC_FIRST_BEFORE_DEADLINE;
    inspector->recorded_all = true;
    inspector->late = false;
}

/* Must the sweep end? The sweep of a trial of bins ends as soon as it is expected to miss its
 * deadline. Other sweeps may continue until the deadline, because a slow beginning may be due to an
 * interruption. */
static bool is_late(const struct inspection *inspection, const struct inspector *inspector) {
    const redcc_int begin = redcc_own_begin(inspection, inspector);
    const redcc_int end = redcc_own_end(inspection, inspector);
    const double done = (double)(inspector->next - begin) / (double)(end - begin);
    return inspection->call->in_bins ? redcc_inspection_will_be_late(inspection, done)
                                     : redcc_inspection_is_late(inspection);
}

bool redcc_sweep_hand_out(const struct inspection *inspection, struct inspector *inspector,
                          redcc_worker *worker) {
    const redcc_int end = redcc_own_end(inspection, inspector), first = inspector->next;
    assert(first <= end);
    if (inspector->failed || !inspector->recorded_all || first == end)
        return false;
    inspector->late = is_late(inspection, inspector);
    if (inspector->late)
        return false;
    inspector->handed = end - first < inspector->block ? end - first : inspector->block;
    inspector->next = first + inspector->handed;
    if (inspection->pace.deadline > 0)
        inspector->block =
            redcc_min(redcc_next_before_deadline(inspector->block), inspector->largest);
    assert(inspector->handed > 0 && inspector->next <= end);
    const bool is_logged = redcc_is_logged(inspection);
    if (!is_logged)
        redcc_sweep_open_block(&inspector->sweep, first);
    redcc_hand_out(inspector, worker, first, inspector->next, 1,
                   is_logged ? inspector->nowhere : inspector->sweep.window);
    return true;
}

void redcc_sweep_flush(struct inspection *inspection, struct inspector *inspector,
                       redcc_worker *worker) {
    if (redcc_is_logged(inspection)) {
        redcc_access_log_take(&inspection->divide.logged[inspector->thread], inspector->entries,
                              worker->entry);
        return;
    }
    redcc_sweep_take_window(&inspector->sweep, worker->alike, worker->inside);
    redcc_sweep_take(&inspector->sweep, inspector->entries, worker->entry);
}

/* Was the block recorded with exactly this number of iterations? */
static bool is_block_recorded(const struct inspection *inspection, struct inspector *inspector) {
    if (!redcc_is_logged(inspection))
        return redcc_sweep_close_block(&inspector->sweep, inspector->handed);
    const struct access_log *logged = &inspection->divide.logged[inspector->thread];
    return !logged->failed && logged->iterations == inspector->next - logged->begin;
}

double redcc_sweep_close(const struct inspection *inspection, struct inspector *inspector) {
    assert(inspector->handed > 0);
    if (!is_block_recorded(inspection, inspector)) {
        inspector->failed = redcc_is_logged(inspection)
                                ? inspection->divide.logged[inspector->thread].failed
                                : inspector->sweep.failed;
        inspector->recorded_all = false;
    }
    inspector->handed = 0;
    const redcc_int begin = redcc_own_begin(inspection, inspector);
    const redcc_int all = redcc_own_end(inspection, inspector) - begin;
    return inspector->block < all ? (double)(inspector->next - begin) / (double)all : 0;
}

double redcc_sweep_done(const struct inspection *inspection) {
    assert(inspection->call->request.trip > 0);
    double done = 0;
    for (int thread = 0; thread < inspection->call->threads; thread++) {
        const struct inspector *inspector = inspection->inspector[thread];
        done += (double)(inspector->next - redcc_own_begin(inspection, inspector));
    }
    return done / (double)inspection->call->request.trip;
}

static void gather_sources(struct inspection *inspection) {
    const struct request *request = &inspection->call->request;
    for (uint32_t s = 0; s < request->loop->source_count; s++) {
        struct range *range = &inspection->sources[s];
        if (request->known[s].end)
            continue;
        *range = redcc_nowhere;
        for (int thread = 0; thread < inspection->call->threads; thread++)
            *range = redcc_range_union(*range,
                                       redcc_range_of(inspection->inspector[thread]->sources[s]));
    }
}

enum reason redcc_sweep_finish(struct inspection *inspection) {
    if (redcc_inspection_failed(inspection))
        return REASON_NO_MEMORY;
    for (int thread = 0; thread < inspection->call->threads; thread++)
        if (!inspection->inspector[thread]->recorded_all)
            return REASON_INSPECTOR;
    for (int thread = 0; thread < inspection->call->threads; thread++)
        if (inspection->inspector[thread]->late)
            return REASON_DEADLINE;
    redcc_gather_touched(inspection);
    gather_sources(inspection);
    const redcc_loop *loop = inspection->call->request.loop;
    const struct touches touches = {inspection->touched, inspection->partition.array_count,
                                    inspection->sources, loop->source_count, loop};
    if (!redcc_ranges_are_disjoint(loop, touches.read, touches.written, touches.written_count,
                                   &inspection->overlap))
        return REASON_OVERLAP;
    return redcc_may_be_aliased(touches) ? REASON_TWO_ADDRESSES : REASON_NONE;
}
