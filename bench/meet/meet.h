/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A loop whose iterations meet in what they update, as programs have it. With BY_HAND its file has
 * the loop as a programmer would write it for threads, with OpenMP, by the same order of updates.
 */
#ifndef MEET_H
#define MEET_H

#include <stdlib.h>

/** Makes the data. */
void make(void);
/** Between two calls, not timed: what a program's next step changes. */
void change(void);
/** The measured loop. */
void call(void);
/** Results, and their number of bytes in *size. */
const void *results(size_t *size);

/** In [0, 1). */
double draw(void);
/** Memory, set to 0. */
void *room(size_t bytes);

#endif
