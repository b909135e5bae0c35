/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The runtime's own threads, for programs without an OpenMP library (docs/decisions/0002). Each
 * thread that executes loops has a separate pool, as with OpenMP. After a region, the pool's
 * threads spin for at most 5 to 25 microseconds, then sleep. They end with the owning thread.
 */
#ifndef REDCC_POOL_H
#define REDCC_POOL_H

#include "base/region.h"

#include <stddef.h>

/** Starts threads until the calling thread's pool has `threads` threads, the caller included, or
 * the system refuses one. Returns how many are available: at most `threads`, and at most 1024.
 * Signals must be blocked, because new threads inherit the mask. stack: bytes of a thread's stack;
 * 0: the default. */
int redcc_pool_prepare(int threads, size_t stack);

/** The number of threads of the calling thread's pool, including itself. */
int redcc_pool_threads(void);

/** Executes work(n, threads, shared) for n = 0 (in the calling thread) ... threads - 1, and waits
 * for all. threads: at most redcc_pool_threads(), after redcc_pool_prepare. */
void redcc_pool_run(int threads, region_work *work, void *shared);

#endif
