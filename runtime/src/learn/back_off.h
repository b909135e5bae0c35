/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Exponential back-off: after a trial that failed the next one waits, each time in a row for twice
 * as long. Of calls, of comparisons, of whatever is counted. */
#ifndef REDCC_LEARN_BACK_OFF_H
#define REDCC_LEARN_BACK_OFF_H

#include "learn/constants.h"

/** All zero: nothing is waited for. */
struct back_off {
    long until;  /**< the count at which the next trial is due */
    long length; /**< of the last wait; 0: the last trial did not fail */
};

/** The wait after one of `length`; 0: the first. */
static inline long redcc_longer(long length) {
    const long most = 128L * LEARN_REST;
    return length == 0 ? LEARN_REST : length < most / 2 ? 2 * length : most;
}

/** At count `now`: waits for so long. */
static inline void redcc_wait_for(struct back_off *it, long now, long length) {
    it->length = length;
    it->until = now + length;
}

/** At count `now`: backs off, but no longer than it was there for so far: little is known of a loop
 *  that has just begun. */
static inline void redcc_back_off(struct back_off *it, long now) {
    const long length = redcc_longer(it->length);
    redcc_wait_for(it, now, length < now ? length : now);
}

#endif
