/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Waiting for another thread to change a word: for a while awake, then asleep. */
#ifndef REDCC_WAIT_H
#define REDCC_WAIT_H

#include <stdatomic.h>
#include <stdbool.h>

/** Returns when *word holds something else than `value`, and sees what was done before that was
 *  stored. *asleep counts who sleeps; several words may share it. threads: of the region. */
void redcc_wait_while(atomic_uint *word, unsigned value, atomic_int *asleep, int threads);

/** The same, of a thread that may have nothing to do for long: it is awake for some 30
 *  microseconds, so that regions that follow each other find it awake. */
void redcc_wait_idle(atomic_uint *word, unsigned value, atomic_int *asleep);

/** Wakes whoever sleeps because of *word, after it was changed (sequentially consistently). */
void redcc_wake(atomic_uint *word, atomic_int *asleep);

#endif
