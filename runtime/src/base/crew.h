/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A team of a region of the program's, all of whose threads have come to the same loop (`omp for`).
 * Its first thread executes the loop. The regions that the runtime opens meanwhile are executed by
 * this thread and the others, who wait for them: no other threads are needed.
 */
#ifndef REDCC_BASE_CREW_H
#define REDCC_BASE_CREW_H

#include "base/region.h"
#include "redcc/structures.h"

/** For the calling thread's team; one of its threads calls it, and tells the others. NULL: no
 *  memory, or OpenMP's library says nothing of teams. */
redcc_crew *redcc_crew_new(void);

/** The calling thread has come to a loop: threads of teams are known to be OpenMP's. */
void redcc_crew_arrive(void);

/** Called by each thread of the team. Returns 1 when the first one has ended the loop, after which
 *  the crew may not be used. The first thread gets 0 at once: it executes the loop. */
int redcc_crew_help(redcc_crew *crew);

/** The first thread has executed the loop. */
void redcc_crew_end(redcc_crew *crew);

/** The number of threads that work for the calling one in its current region; 0: none do. */
int redcc_crew_threads(void);

/** As redcc_region_run, by `threads` of them; at most redcc_crew_threads() > 0. */
void redcc_crew_run(int threads, region_work *work, void *shared);

#endif
