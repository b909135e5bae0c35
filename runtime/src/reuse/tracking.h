/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Write tracking: sources of a kept plan that need not be read again, because the system shows that
 * they have not been written since they were compared (docs/decisions/0007).
 */
#ifndef REDCC_TRACKING_H
#define REDCC_TRACKING_H

#include "learn/back_off.h"
#include "reuse/reading.h"

/** State of a source; version and ends are valid for one reading only. */
struct tracking {
    struct reading reading;  /* its range when tracking of its pages began */
    uint64_t version;        /* of its whole pages, as they were compared; 0: not tracked */
    struct fingerprint ends; /* of the bytes outside of them */
    uint64_t begun;          /* in this execution: a version, valid if the comparison finds no
                              * change; or 0 */
    bool is_untouched;       /* in this execution: the whole pages are untouched */
    uint32_t stable_count;   /* consecutive comparisons without a change; sequential calls between
                              * them count as well */
    uint32_t skipped;        /* number of comparisons skipped since it has been tracked */
};

/** Queries whether the whole pages of the source, with the range `reading`, are untouched, and
 *  begins to track them when it is time. *rest is the back-off of tracking that did not pay;
 *  *earned: seconds that the plan has saved, less the possible loss by tracking this source. */
void redcc_tracking_ask(struct tracking *tracking, struct reading reading, struct back_off *rest,
                        double *earned);

/** Is the tracked source unchanged? Reads the bytes outside of its whole pages. Any thread. */
bool redcc_tracking_unchanged(const struct tracking *tracking, struct reading reading);

/** The source was read and is unchanged; `skipped_calls` were sequential since. Called by one
 *  thread. */
void redcc_tracking_stable(struct tracking *tracking, struct reading reading, long skipped_calls);

#endif
