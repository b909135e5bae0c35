/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A crew is the team of one of the program's own OpenMP regions, if all threads of the team reach
 * the same loop (`omp for`). The first thread executes the loop. The other threads wait, and help
 * to execute the regions that the runtime opens for the loop. So these regions need no more
 * threads.
 */
#ifndef REDCC_BASE_CREW_H
#define REDCC_BASE_CREW_H

#include "base/region.h"
#include "redcc/structures.h"

/** Forms a crew of the calling thread's team. One thread of the team calls this function and passes
 * the result to the others. NULL: out of memory, or OpenMP's library lacks a function that the
 * runtime needs. */
redcc_crew *redcc_crew_new(void);

/** Registers the calling thread as a thread of OpenMP, unless it is the first thread of its team.
 */
void redcc_crew_arrive(void);

/** Called by each thread of the team. The first thread gets 0 at once and executes the loop. The
 * others get 1 when the loop has ended; the crew may not be used afterwards. */
int redcc_crew_help(redcc_crew *crew);

/** Called by the first thread after the loop: releases the other threads. The crew is freed by the
 * last thread that leaves redcc_crew_help or this function. */
void redcc_crew_end(redcc_crew *crew);

/** The number of threads that may execute the calling thread's regions because it leads a crew; 0
 * if it leads none. */
int redcc_crew_threads(void);

/** As redcc_region_run, but the threads of the crew that the caller leads execute the region:
 * `threads` of them, at least 2 and at most redcc_crew_threads(). */
void redcc_crew_run(int threads, region_work *work, void *shared);

#endif
