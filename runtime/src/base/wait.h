/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Waits for another thread to change a word: spins for a while, then sleeps. */
#ifndef REDCC_WAIT_H
#define REDCC_WAIT_H

#include <stdatomic.h>
#include <stdbool.h>

/** Returns when *word differs from `value`, with all writes visible that preceded the store.
 * *asleep counts sleeping threads; several words may share it. threads: the region's; if they
 * outnumber the processors, the wait does not spin. */
void redcc_wait_while(atomic_uint *word, unsigned value, atomic_int *asleep, int threads);

/** The same for a thread that may be idle for long: it spins for at most 5 to 25 microseconds, so
 * that consecutive regions find it awake. */
void redcc_wait_idle(atomic_uint *word, unsigned value, atomic_int *asleep);

/** Wakes the threads that sleep on *word. The caller has changed it by a sequentially consistent
 * write. */
void redcc_wake(atomic_uint *word, atomic_int *asleep);

#endif
