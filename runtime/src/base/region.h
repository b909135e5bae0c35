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

/** Does the program lack an OpenMP library, so that the threads of pool.h execute regions? */
bool redcc_region_is_own(void);

/** The number of threads for a region, at least 1. If the caller leads a crew, this is the crew's
 * number of threads. Otherwise it is the number of OpenMP's library or, without a library, that of
 * OpenMP's environment variables (default: the number of processors). */
int redcc_region_threads(void);

/** Is the calling thread within a parallel region of the program or of the runtime? A region whose
 * crew (crew.h) the thread leads does not count. */
bool redcc_region_is_nested(void);

/** Opens a region of `threads` threads and waits for its end. OpenMP or a crew may give it fewer
 * threads. */
void redcc_region_run(int threads, region_work *work, void *shared);

#endif
