/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** On which processors the threads of one region run. */
#ifndef REDCC_BASE_CORES_H
#define REDCC_BASE_CORES_H

#include <stdatomic.h>
#include <stdbool.h>

/** Of the first 1024 processors those that a thread of the region was on when it came; how many
 *  threads came beside the one that began it. */
struct cores {
    _Atomic unsigned long taken[1024 / (8 * sizeof(unsigned long))];
    _Atomic int come;
};

/** Before the region, by the thread that begins it: it stays where it is. */
void redcc_cores_begin(struct cores *cores);

/** By each other thread of the region, when it comes. A thread on a processor that another one of
 *  them is on moves to one that none is on, if it may run there; not twice in 2 ms. */
void redcc_cores_take(struct cores *cores);

/** By the thread that began the region, in it, where the system had to start some of the `others`:
 *  waits for them, and moves to a processor that none is on where they do not come in 0.15 ms. For
 * a new thread may be kept waiting on this one. */
void redcc_cores_give_way(struct cores *cores, int others);

/** By any thread: the one that began the region has been moved. */
void redcc_cores_change(struct cores *cores, int from, int to);

/** Would so many threads more have to share processors with other programs, as far as one look
 *  says, which is up to a millisecond old? False where it is not known, or where the calling thread
 *  may not run on all processors. Any thread. */
bool redcc_cores_are_wanted(int more);

#endif
