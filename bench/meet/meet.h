/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Interface of the files of this folder. Each file has a loop, as found in programs, in which
 * several iterations update the same elements. With BY_HAND, the file instead contains the loop as
 * a programmer would parallelise it with OpenMP, keeping the order of updates.
 */
#ifndef MEET_H
#define MEET_H

#include <stdlib.h>

/** Makes the data. */
void make(void);
/** Changes the data as the next step of a program would. Called between two calls of the loop, and
 * not timed. */
void change(void);
/** Executes the measured loop. */
void call(void);
/** Returns the results; *size receives their number of bytes. */
const void *results(size_t *size);

/** A pseudo-random number in [0, 1). */
double draw(void);
/** Allocates zeroed memory. */
void *room(size_t bytes);

#endif
