/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A crew: the threads of one of the program's own OpenMP regions, all of which have reached the
 * same loop (`omp for`). The first thread executes the loop. The others wait, and execute with it
 * the regions that the runtime opens for the loop, so no other threads are needed.
 */
#ifndef REDCC_BASE_CREW_H
#define REDCC_BASE_CREW_H

#include "base/region.h"
#include "redcc/structures.h"

/** Makes a crew of the calling thread's team; one thread of the team calls this and passes the
 * result to the others. NULL: out of memory, or OpenMP's library does not export the team's size.
 */
redcc_crew *redcc_crew_new(void);

/** Registers the calling thread, which has reached a loop, as a thread made by OpenMP. */
void redcc_crew_arrive(void);

/** Called by each thread of the team. The first thread gets 0 at once and executes the loop. The
 * others get 1 when the loop has ended; the crew may not be used afterwards. */
int redcc_crew_help(redcc_crew *crew);

/** Called by the first thread after the loop: releases the others. */
void redcc_crew_end(redcc_crew *crew);

/** The number of threads of the crew that the calling thread leads; 0: it leads none. */
int redcc_crew_threads(void);

/** As redcc_region_run, by `threads` threads of the crew: at most redcc_crew_threads(), which must
 * be above 0. */
void redcc_crew_run(int threads, region_work *work, void *shared);

#endif
