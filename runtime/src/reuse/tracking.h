/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Write tracking: a kept plan's sources that need not be read to be compared, because the system
 * shows that nobody wrote to them since they were (docs/decisions/0007).
 */
#ifndef REDCC_TRACKING_H
#define REDCC_TRACKING_H

#include "learn/back_off.h"
#include "reuse/reading.h"

/** What is known of a source; version and ends hold for one reading only. */
struct tracking {
    struct reading reading;  /* where it lay when its pages began to be tracked */
    uint64_t version;        /* of its whole pages, as they were compared; 0: not tracked */
    struct fingerprint ends; /* of what lies beside them */
    uint64_t begun;          /* this execution's: a version, if comparing finds no change; or 0 */
    bool stands;             /* this execution's: the whole pages are untouched */
    uint32_t stable_count;   /* how often in a row it was read and had not changed; calls in between
                                that were the sequential loop's count as well */
    uint32_t skipped;        /* how often it was not read since it has been tracked */
};

/** Asks whether the whole pages of the source that lies as `reading` says are untouched, and begins
 *  to track them where it is time. *rest is the back-off of tracking that did not pay; *earned:
 *  seconds that the plan has saved, less what to track this source may cost for nothing. */
void redcc_tracking_ask(struct tracking *tracking, struct reading reading, struct back_off *rest,
                        double *earned);

/** Is the tracked source what it was? Reads what lies beside its whole pages. Any thread. */
bool redcc_tracking_unchanged(const struct tracking *tracking, struct reading reading);

/** The source was read and is what it was; `skipped_calls` were the sequential loop's since. Called
 *  by one thread. */
void redcc_tracking_stable(struct tracking *tracking, struct reading reading, long skipped_calls);

#endif
