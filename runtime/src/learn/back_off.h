/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Exponential back-off: after a failed trial the next one waits, twice as long after each
 *  consecutive failure. Counts calls, comparisons, or other events. */
#ifndef REDCC_LEARN_BACK_OFF_H
#define REDCC_LEARN_BACK_OFF_H

#include "learn/constants.h"

/** Zero: no wait. */
struct back_off {
    long until;  /**< the count at which the next trial is due */
    long length; /**< of the last wait; 0: the last trial did not fail */
};

/** The wait after one of `length`; 0: the first. */
static inline long redcc_longer(long length) {
    const long most = 128L * LEARN_REST;
    return length == 0 ? LEARN_REST : length < most / 2 ? 2 * length : most;
}

/** At count `now`: waits for `length` events. */
static inline void redcc_wait_for(struct back_off *it, long now, long length) {
    it->length = length;
    it->until = now + length;
}

/** At count `now`: backs off, but for at most the count so far, since little is known of a new
 *  loop. */
static inline void redcc_back_off(struct back_off *it, long now) {
    const long length = redcc_longer(it->length);
    redcc_wait_for(it, now, length < now ? length : now);
}

#endif
