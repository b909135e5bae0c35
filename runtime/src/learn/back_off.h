/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Exponential back-off: after a failed trial the next trial waits for a number of calls or other
 * events. This number doubles with each consecutive failure, up to a limit. */
#ifndef REDCC_LEARN_BACK_OFF_H
#define REDCC_LEARN_BACK_OFF_H

#include "learn/constants.h"

/** The state of a back-off. If it is zero, there is no wait. */
struct back_off {
    long until;  /**< the count at which the next trial is due */
    long length; /**< length of the last wait; 0: the last trial did not fail */
};

/** The length of the wait that follows a wait of `length`; if `length` is 0, the length of the
 * first wait. */
static inline long redcc_longer(long length) {
    const long most = 128L * LEARN_BACK_OFF;
    return length == 0 ? LEARN_BACK_OFF : length < most / 2 ? 2 * length : most;
}

/** Begins a wait of `length` events at count `now`. */
static inline void redcc_wait_for(struct back_off *it, long now, long length) {
    it->length = length;
    it->until = now + length;
}

/** Begins the next wait at count `now`: with twice the length of the last one, up to the limit. But
 * it is never longer than `now`, because little is known of a loop with few calls. */
static inline void redcc_back_off(struct back_off *it, long now) {
    const long length = redcc_longer(it->length);
    redcc_wait_for(it, now, length < now ? length : now);
}

#endif
