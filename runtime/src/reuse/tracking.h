/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Write tracking: a kept plan's sources need not be read again as long as the system shows that
 * they have not been written since they were compared (docs/decisions/0007).
 */
#ifndef REDCC_TRACKING_H
#define REDCC_TRACKING_H

#include "learn/back_off.h"
#include "reuse/reading.h"

/** The state of write tracking for a source. `version` and `ends` belong to `reading`. */
struct tracking {
    struct reading reading; /* the source's reading when tracking of its pages began */
    uint64_t version; /* version of the reading's whole pages when they were compared; 0: they are
                         not tracked */
    struct fingerprint ends; /* fingerprint of the bytes outside of the whole pages */
    uint64_t begun; /* version of the tracking that began in this execution; it becomes valid if the
                       comparison finds no change. 0: none */
    bool is_untouched; /* result of this execution's query: the reading's whole pages are unmodified
                        */
    uint32_t stable_count; /* number of consecutive comparisons without a change, plus the number of
                              sequential calls between them */
    uint32_t skipped;      /* number of comparisons skipped since tracking began */
};

/** Queries whether the whole pages of the reading are unmodified. If they are not tracked, begins
 * to track them if that is likely to pay. *rest is the back-off after tracking that did not pay.
 * *earned has the seconds that the plan has saved; the possible loss by tracking is subtracted from
 * it. */
void redcc_tracking_ask(struct tracking *tracking, struct reading reading, struct back_off *rest,
                        double *earned);

/** Is the tracked source unchanged? Called if the source's whole pages are unmodified; reads only
 * its other bytes. Any thread may call it. */
bool redcc_tracking_unchanged(const struct tracking *tracking, struct reading reading);

/** Called by one thread when the source was read and found unchanged. `skipped_calls` is the number
 * of sequential calls since the comparison before. */
void redcc_tracking_stable(struct tracking *tracking, struct reading reading, long skipped_calls);

#endif
