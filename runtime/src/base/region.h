/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Parallel regions that the runtime opens. They are executed by the threads of the program's OpenMP
 * library if it has one, otherwise by the runtime's own threads (docs/decisions/0002).
 */
#ifndef REDCC_REGION_H
#define REDCC_REGION_H

#include <stdbool.h>

/** The function that each thread of a region calls. `number` is the thread's number, from 0 to
 * threads - 1. */
typedef void region_work(int number, int threads, void *shared);

/** Does the program lack an OpenMP library? Then the threads of pool.h execute regions. */
bool redcc_region_is_own(void);

/** The number of threads for a region, at least 1. If the caller leads a crew, it is the crew's
 * number of threads. Otherwise OpenMP's library gives the number. Without a library,
 * OMP_NUM_THREADS and OMP_THREAD_LIMIT give it (default: the number of processors). */
int redcc_region_threads(void);

/** Is the calling thread within a parallel region of the program, or within an execution by the
 * runtime? A region of the program does not count if the thread leads its crew (crew.h). */
bool redcc_region_is_nested(void);

/** Opens a region of `threads` threads and waits for its end. OpenMP or a crew may provide fewer
 * threads. */
void redcc_region_run(int threads, region_work *work, void *shared);

#endif
