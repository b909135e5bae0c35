/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Times the slice, after the sample. A slice may take longer than the updates, for example if it
 * searches for a nearest centre. */
#include "inspect/inspection.h"

#include "base/clock.h"

#include <assert.h>

enum {
    TIMED = 16, /* number of timed iterations per thread; their data stay in the caches */
    PASSES = 3  /* number of passes over these iterations: the first pass loads their data, and an
                   interruption may disturb another one */
};

/* Do auto's estimates need the time of the slice? They do not if owners are kept from an earlier
 * execution, or after a dry run, whose time is known. */
static bool is_wanted(const struct inspection *inspection) {
    const struct call *call = inspection->call;
    return !call->method && !call->in_bins && inspection->partition.share == 0 &&
           !(call->request.loop->flags & REDCC_DRY_RUN);
}

static void end_pass(struct slice_timing *it) {
    const double seconds = redcc_seconds() - it->began;
    if (it->least <= 0 || seconds < it->least)
        it->least = seconds;
}

bool redcc_timing_hand_out(const struct inspection *inspection, struct inspector *inspector,
                           redcc_worker *worker) {
    struct slice_timing *it = &inspector->timing;
    const redcc_int begin = redcc_own_begin(inspection, inspector);
    const redcc_int end = redcc_own_end(inspection, inspector);
    if (!is_wanted(inspection) || begin == end)
        return false;
    if (it->passes > 0)
        end_pass(it);
    if (it->passes == PASSES)
        return false;
    const redcc_int stride = (end - begin) / TIMED | 1;
    it->passes++;
    it->iterations = (end - begin + stride - 1) / stride;
    redcc_hand_out(inspector, worker, begin, end, stride, inspector->nowhere);
    it->began = redcc_seconds();
    return true;
}

double redcc_slice_seconds(const struct inspection *inspection) {
    double seconds = 0;
    redcc_int iterations = 0;
    for (int thread = 0; thread < inspection->call->threads; thread++) {
        const struct slice_timing *it = &inspection->inspector[thread]->timing;
        seconds += it->least;
        iterations += it->iterations;
    }
    return iterations > 0 ? seconds / (double)iterations : 0;
}
