/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Waits for another thread to change a word: spins for a while, then sleeps. */
#ifndef REDCC_WAIT_H
#define REDCC_WAIT_H

#include <stdatomic.h>
#include <stdbool.h>

/** Returns when *word differs from `value`. All writes before the store to *word are then visible.
 * *asleep counts sleeping threads; several words may share it. `threads` is the number of threads
 * of the region; if it exceeds the number of processors, the wait does not spin. */
void redcc_wait_while(atomic_uint *word, unsigned value, atomic_int *asleep, int threads);

/** As redcc_wait_while, for a thread that may be idle for long. It spins for at most 5 to 25
 * microseconds, so that a region that follows soon finds it awake. */
void redcc_wait_idle(atomic_uint *word, unsigned value, atomic_int *asleep);

/** Wakes the threads that sleep on *word. The caller must have changed *word by a sequentially
 * consistent write. */
void redcc_wake(atomic_uint *word, atomic_int *asleep);

#endif
