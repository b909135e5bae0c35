/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The runtime's own threads, for programs without an OpenMP library (docs/decisions/0002). Each
 * thread that executes loops has its own ones, as with OpenMP. They spin for some 30 microseconds
 * after a region, then sleep; they end with the thread that they belong to.
 */
#ifndef REDCC_POOL_H
#define REDCC_POOL_H

#include "base/region.h"

#include <stddef.h>

/** Starts threads until the calling thread has `threads` including itself, or the system refuses
 *  one. Returns how many it has, at most `threads`. Signals must be blocked, because new threads
 *  inherit the mask. stack: bytes of a thread's stack; 0: the default. */
int redcc_pool_prepare(int threads, size_t stack);

/** The number of threads of the calling thread, including itself. */
int redcc_pool_threads(void);

/** Executes work(n, threads, shared) for n = 0 (in the calling thread) ... threads - 1, and returns
 *  when all have returned. threads: at most redcc_pool_threads(). */
void redcc_pool_run(int threads, region_work *work, void *shared);

#endif
