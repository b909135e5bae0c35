/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The access log: all touches are told once more and kept; and what is made of it: owners cut from
 *  the access graph (ownership/graph/divide.h), or iterations in levels (ownership/graph/levels.h).
 */
#include "inspect/inspection.h"

#include <string.h>

/* About how many touches of leading or of further groups a thread will tell, by the sample. */
static size_t expected_touches(const struct inspection *inspection,
                               const struct inspector *inspector, bool leading) {
    const struct partition *partition = &inspection->partition;
    double touches = 0, iterations = 1;
    for (int thread = 0; thread < inspection->call->threads; thread++) {
        const struct sample *sample = &inspection->inspector[thread]->sample;
        for (size_t i = 0; i < sample->count; i++)
            if ((partition->group_of[sample->item[i].array] == partition->leader) == leading)
                touches += (double)sample->keep_each;
        iterations += sample->iterations;
    }
    const double share =
        (double)(redcc_own_end(inspection, inspector) - redcc_own_begin(inspection, inspector));
    const double expected = share * (touches / iterations) * 1.02;
    return (size_t)expected + (size_t)share / 16;
}

enum divide_result redcc_log_begin(struct inspection *inspection, bool in_levels) {
    struct divide *divide = &inspection->divide;
    const int threads = inspection->call->threads;
    const enum divide_result result =
        redcc_divide_begin(divide, &inspection->partition, inspection->touched, threads,
                           inspection->call->request.trip);
    divide->barrier = inspection->barrier;
    divide->deadline = inspection->deadline;
    if (in_levels) /* whatever they take: the method was named */
        divide->most_told = (size_t)REDCC_NO_UNIT / (size_t)threads;
    return result;
}

void redcc_log_start(const struct inspection *inspection, struct inspector *inspector) {
    const struct divide *divide = &inspection->divide;
    inspector->at = redcc_own_begin(inspection, inspector);
    inspector->failed =
        !redcc_told_begin(&divide->told[inspector->thread], &divide->units, divide->partition,
                          inspector->at, expected_touches(inspection, inspector, true),
                          expected_touches(inspection, inspector, false), divide->most_told);
}

bool redcc_log_hand_out(const struct inspection *inspection, struct inspector *inspector,
                        redcc_worker *worker) {
    const redcc_int first = inspector->at, end = redcc_own_end(inspection, inspector);
    inspector->late = redcc_inspection_is_late(inspection);
    if (inspector->failed || inspector->late || first == end)
        return false;
    const bool all = inspection->deadline <= 0 || end - first < REDCC_BLOCK_BEFORE_DEADLINE;
    inspector->at = all ? end : first + REDCC_BLOCK_BEFORE_DEADLINE;
    redcc_hand_out(inspector, worker, first, inspector->at, 1, inspector->nowhere);
    return true;
}

enum divide_result redcc_log_finish(const struct inspection *inspection) {
    bool failed = false, too_much = false;
    for (int thread = 0; thread < inspection->call->threads; thread++) {
        const struct inspector *inspector = inspection->inspector[thread];
        const struct told *told = &inspection->divide.told[thread];
        const redcc_int own =
            redcc_own_end(inspection, inspector) - redcc_own_begin(inspection, inspector);
        failed = failed || inspector->failed || told->failed;
        too_much = too_much || told->too_much || told->iterations != own;
    }
    if (failed)
        return DIVIDE_NO_MEMORY;
    return too_much ? DIVIDE_UNSUITABLE : DIVIDE_DONE;
}

void redcc_partition_share(struct inspection *inspection, struct inspector *inspector,
                           bool joined) {
    struct divide *divide = &inspection->divide;
    const int thread = inspector->thread;
    const enum divide_result result = joined ? redcc_divide_join(divide, thread, inspector->seen)
                                             : redcc_divide(divide, thread, inspector->seen);
    memset(inspector->executed, 0, inspection->partition.owners * sizeof *inspector->executed);
    if (result == DIVIDE_DONE)
        redcc_sweep_count(&divide->sweep[thread], inspector->executed);
}

bool redcc_partition_levels(struct inspection *inspection) {
    return redcc_levels_begin(&inspection->levels, inspection->divide.told,
                              inspection->call->threads,
                              inspection->call->request.loop->flags & REDCC_EVERY_ITERATION);
}
