/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A sense-reversing barrier for the threads of a region, whichever library created them. The last
 * thread to arrive may execute a serial section before the other threads continue.
 */
#ifndef REDCC_BARRIER_H
#define REDCC_BARRIER_H

#include <stdalign.h>
#include <stdatomic.h>
#include <stdbool.h>

/** A barrier is zero-initialised and reusable, with any number of threads. */
struct barrier {
    alignas(64) atomic_uint arrived;
    alignas(64) atomic_uint phase; /* incremented when all threads have arrived */
    atomic_int asleep;             /* number of sleeping threads */
};

/** Called by each of `threads` threads. The last one to call gets true immediately and must call
 * redcc_barrier_release. The others get false after that release. They then see all writes that any
 * thread made before it arrived, and all writes that the last thread made before the release. */
bool redcc_barrier_arrive(struct barrier *barrier, int threads);

/** Releases the waiting threads. */
void redcc_barrier_release(struct barrier *barrier);

/** Returns once all `threads` callers have arrived. */
void redcc_barrier_wait(struct barrier *barrier, int threads);

#endif
