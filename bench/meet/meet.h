/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Interface of the files of this folder. Each has a loop, as found in programs, whose iterations
 * update the same elements. With BY_HAND the file contains the loop as a programmer would
 * parallelise it with OpenMP, in the same order of updates.
 */
#ifndef MEET_H
#define MEET_H

#include <stdlib.h>

/** Makes the data. */
void make(void);
/** Makes the changes of a program's next step. Called between two calls of the loop, and not
 *  timed. */
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
