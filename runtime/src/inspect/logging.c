/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The access log: a sweep that stores all touches. The log is used to choose owners
 * (ownership/graph/divide.h) or to assign iterations to levels (ownership/graph/levels.h). Units
 * are numbered before the sweep, over a range slightly larger than that of the sample. If a touch
 * lies outside of this range, the sweep is repeated with the range that the first sweep has
 * found. */
#include "inspect/inspection.h"

#include "base/memory.h"

#include <assert.h>
#include <string.h>

/* The approximate number of touches per iteration, according to the sample: of the leading group if
 * `leading` is set, otherwise of the other groups. */
static double touches_an_iteration(const struct inspection *inspection, bool leading) {
    const struct partition *partition = &inspection->partition;
    double touches = 0, iterations = 1;
    for (int thread = 0; thread < inspection->call->threads; thread++) {
        const struct sample *sample = &inspection->inspector[thread]->sample;
        for (size_t i = 0; i < sample->count; i++)
            if ((partition->group_of[sample->item[i].array] == partition->leader) == leading)
                touches += (double)sample->keep_each;
        iterations += sample->iterations;
    }
    return touches / iterations;
}

/* A slightly too high estimate of the number of touches (as in touches_an_iteration) in the
 * iterations of this thread's share. */
static size_t expected_touches(const struct inspection *inspection,
                               const struct inspector *inspector, bool leading) {
    const double share =
        (double)(redcc_own_end(inspection, inspector) - redcc_own_begin(inspection, inspector));
    const double expected = share * touches_an_iteration(inspection, leading) * 1.02;
    return (size_t)expected + (size_t)share / 16;
}

bool redcc_is_logged(const struct inspection *inspection) {
    return inspection->route == ROUTE_GRAPH || inspection->route == ROUTE_LEVELS;
}

/* The range of a group that the sample predicts. */
static struct range expected_range(const struct inspection *inspection, uint32_t group) {
    const struct range sampled = inspection->touched[group];
    if (redcc_range_empty(sampled))
        return sampled;
    const uintptr_t unit = inspection->partition.arrays[group].unit;
    const uintptr_t more = (sampled.end - sampled.first) / 16 + 64 * unit;
    return (struct range){sampled.first > more ? sampled.first - more : 1,
                          sampled.end < UINTPTR_MAX - more ? sampled.end + more : UINTPTR_MAX};
}

enum divide_result redcc_log_begin(struct inspection *inspection, bool is_exact) {
    struct divide *divide = &inspection->divide;
    const uint32_t arrays = inspection->partition.array_count;
    const int threads = inspection->call->threads;
    struct range *range = redcc_memory_alloc(arrays * sizeof *range);
    inspection->is_exact = is_exact;
    redcc_divide_end(divide);
    if (!range)
        return DIVIDE_NO_MEMORY;
    for (uint32_t group = 0; group < arrays; group++)
        range[group] = is_exact ? inspection->touched[group] : expected_range(inspection, group);
    const redcc_int trip = inspection->call->request.trip;
    const double touches = (double)trip * (touches_an_iteration(inspection, true) +
                                           touches_an_iteration(inspection, false));
    const enum divide_result result =
        redcc_divide_begin(divide, &inspection->partition, range, threads, trip, touches);
    redcc_memory_free(range);
    divide->barrier = inspection->barrier;
    divide->deadline = inspection->pace.deadline;
    if (inspection->route ==
        ROUTE_LEVELS) /* the method was named, so the log's length is not limited */
        divide->most_logged = (size_t)REDCC_NO_UNIT / (size_t)threads;
    return result;
}

bool redcc_log_start(const struct inspection *inspection, struct inspector *inspector) {
    const struct divide *divide = &inspection->divide;
    const size_t expected[] = {expected_touches(inspection, inspector, true),
                               expected_touches(inspection, inspector, false)};
    assert(redcc_is_logged(inspection));
    struct access_log *logged = &divide->logged[inspector->thread];
    redcc_access_log_end(logged);
    return redcc_access_log_begin(logged, &divide->units, divide->partition, inspector->seen,
                                  redcc_own_begin(inspection, inspector), expected,
                                  divide->most_logged);
}

enum divide_result redcc_log_finish(const struct inspection *inspection) {
    bool beyond = false, too_much = inspection->divide.units.leading == 0;
    for (int thread = 0; thread < inspection->call->threads; thread++) {
        beyond |= inspection->divide.logged[thread].beyond;
        too_much |= inspection->divide.logged[thread].too_much;
    }
    if (beyond && !inspection->is_exact)
        return DIVIDE_BEYOND;
    return beyond || too_much ? DIVIDE_UNSUITABLE : DIVIDE_DONE;
}

void redcc_partition_share(struct inspection *inspection, struct inspector *inspector,
                           bool joined) {
    assert(inspection->route == ROUTE_GRAPH);
    struct divide *divide = &inspection->divide;
    const int thread = inspector->thread;
    const enum divide_result result = joined ? redcc_divide_join(divide, thread, inspector->seen)
                                             : redcc_divide(divide, thread, inspector->seen);
    memset(inspector->executed, 0, inspection->partition.owners * sizeof *inspector->executed);
    if (result == DIVIDE_DONE)
        redcc_sweep_count(&divide->sweep[thread], inspector->executed);
}

bool redcc_partition_levels(struct inspection *inspection) {
    assert(redcc_is_logged(inspection));
    return redcc_levels_begin(&inspection->levels, inspection->divide.logged,
                              inspection->call->threads,
                              inspection->call->request.loop->flags & REDCC_EVERY_ITERATION);
}
