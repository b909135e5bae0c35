/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The runtime's own threads, for programs without an OpenMP library (docs/decisions/0002). As with
 * OpenMP, each thread that executes loops has a separate pool. After a region, the pool's threads
 * spin for at most 5 to 25 microseconds, then sleep. They end when the thread that owns the pool
 * ends.
 */
#ifndef REDCC_POOL_H
#define REDCC_POOL_H

#include "base/region.h"

#include <stddef.h>

/** Starts threads until the calling thread's pool has `threads` threads, including the caller, or
 * the system refuses to start one. Returns how many are available: at most `threads`, and at most
 * 1024. Signals must be blocked, because new threads inherit the mask. `stack` is the size of a
 * thread's stack in bytes; 0: the default size. */
int redcc_pool_prepare(int threads, size_t stack);

/** The number of threads of the calling thread's pool, including the calling thread. */
int redcc_pool_threads(void);

/** Executes work(n, threads, shared) for n = 0 to threads - 1 and waits for all of them; the
 * calling thread executes n = 0. redcc_pool_prepare must have provided as many threads: `threads`
 * is at most redcc_pool_threads(). */
void redcc_pool_run(int threads, region_work *work, void *shared);

#endif
