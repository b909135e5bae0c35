/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loops that have no state yet. Creating a loop's state takes some 40 microseconds, five executions
 * of a loop of 20,000 additions. So it is created only after enough executions have been so long
 * that waking threads is worth it. Until then one word, stored instead of the pointer to the state,
 * determines when the loop is timed next. Thread-safe.
 */
#ifndef REDCC_UNMADE_H
#define REDCC_UNMADE_H

#include "redcc/runtime.h"

#include <stdbool.h>

/** Is this a word, not a pointer to a state? */
static inline bool redcc_is_unmade(const void *state) {
    return !state || ((__UINTPTR_TYPE__)state & 1);
}

/** Counts a call of `trip` iterations that runs the original loop, and returns whether to time
 *  it. */
bool redcc_unmade_call(void **state, redcc_int trip);

/** Records a timing. 0: the loop is not worth a state yet. Otherwise the caller creates the state;
 * the result is the number of executions that the timing represents, at least this one and those
 * counted before it. */
int redcc_unmade_timed(void **state, redcc_int trip, double seconds);

#endif
