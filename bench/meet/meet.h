/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A file with a loop, as found in programs, whose iterations update the same elements. With BY_HAND
 * the file contains the loop as a programmer would parallelise it with OpenMP, in the same order of
 * updates.
 */
#ifndef MEET_H
#define MEET_H

#include <stdlib.h>

/** Makes the data. */
void make(void);
/** Called between two calls, not timed: makes the changes of a program's next step. */
void change(void);
/** The measured loop. */
void call(void);
/** The results; *size: their number of bytes. */
const void *results(size_t *size);

/** A pseudo-random number in [0, 1). */
double draw(void);
/** Zeroed memory. */
void *room(size_t bytes);

#endif
