/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A sense-reversing barrier for the threads of a region, whoever's threads they are. Whoever
 * arrives last may do something alone before the others go on.
 */
#ifndef REDCC_BARRIER_H
#define REDCC_BARRIER_H

#include <stdalign.h>
#include <stdatomic.h>
#include <stdbool.h>

/** All zero at the beginning; may be used again and again, by any number of threads. */
struct barrier {
    alignas(64) atomic_uint arrived;
    alignas(64) atomic_uint phase; /* goes up when all have arrived */
    atomic_int asleep;             /* how many have to be woken then */
};

/** Of `threads` callers, the last one gets true at once and must call redcc_barrier_release; the
 *  others get false after it did. They see what all did before arriving, and what the last did
 *  before releasing. */
bool redcc_barrier_arrive(struct barrier *barrier, int threads);

/** Lets the others go on. */
void redcc_barrier_release(struct barrier *barrier);

/** Nobody goes on before all `threads` callers are there. */
void redcc_barrier_wait(struct barrier *barrier, int threads);

#endif
