/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Write tracking: avoids reading the sources of a kept plan again while the system shows that they
 * have not been written since they were compared (docs/decisions/0007).
 */
#ifndef REDCC_TRACKING_H
#define REDCC_TRACKING_H

#include "learn/back_off.h"
#include "reuse/reading.h"

/** State of a source; version and ends are valid for one reading only. */
struct tracking {
    struct reading reading; /* the source's range when tracking of its pages began */
    uint64_t version;       /* version of its whole pages when they were compared; 0: not tracked */
    struct fingerprint ends; /* of the bytes outside of the whole pages */
    uint64_t begun;          /* version of tracking begun in this execution, which becomes valid if
                              * the comparison finds no change; or 0 */
    bool is_untouched;       /* result of this execution's query: the whole pages are untouched */
    uint32_t stable_count;   /* consecutive comparisons without a change, plus the sequential calls
                              * between them */
    uint32_t skipped;        /* number of comparisons skipped since tracking began */
};

/** Queries whether the whole pages of the source, with the range `reading`, are untouched, and
 * begins to track them when that is likely to pay. *rest: the back-off after tracking that did not
 * pay; *earned: seconds that the plan has saved, from which the possible loss by tracking is
 * subtracted. */
void redcc_tracking_ask(struct tracking *tracking, struct reading reading, struct back_off *rest,
                        double *earned);

/** Is the tracked source unchanged? Reads the bytes outside of its whole pages. Any thread. */
bool redcc_tracking_unchanged(const struct tracking *tracking, struct reading reading);

/** Called by one thread when the source was read and is unchanged; `skipped_calls`: sequential
 * calls since the last comparison. */
void redcc_tracking_stable(struct tracking *tracking, struct reading reading, long skipped_calls);

#endif
