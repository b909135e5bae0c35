/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A crew is the team of one of the program's own OpenMP regions; all its threads reach the same
 * loop (`omp for`). The first thread executes the loop. The others wait, and execute with it the
 * regions that the runtime opens for the loop, so no other threads are needed.
 */
#ifndef REDCC_BASE_CREW_H
#define REDCC_BASE_CREW_H

#include "base/region.h"
#include "redcc/structures.h"

/** Makes a crew of the calling thread's team; one thread of the team calls this and passes the
 * result to the others. NULL: out of memory, or OpenMP's library lacks a function that the runtime
 * needs.
 */
redcc_crew *redcc_crew_new(void);

/** Registers the calling thread as made by OpenMP, unless it is the first of its team. */
void redcc_crew_arrive(void);

/** Called by each thread of the team. The first thread gets 0 at once and executes the loop. The
 * others get 1 when the loop has ended; the crew may not be used afterwards. */
int redcc_crew_help(redcc_crew *crew);

/** Called by the first thread after the loop: releases the others. The last one to return frees the
 * crew. */
void redcc_crew_end(redcc_crew *crew);

/** The number of threads of the crew that the calling thread leads in its current region; 0:
 * none. */
int redcc_crew_threads(void);

/** As redcc_region_run, by `threads` threads of the crew: 2 to redcc_crew_threads(). */
void redcc_crew_run(int threads, region_work *work, void *shared);

#endif
