/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loops that have no state yet. Creating a loop's state takes some 40 microseconds, as long as five
 * executions of a loop of 20,000 additions. So a state is created only after the loop has taken
 * long enough, in executions that were each so long that waking threads for them is worthwhile.
 * Until then, loop->state is an odd word in place of a pointer. This word determines when the loop
 * is timed next. Thread-safe.
 */
#ifndef REDCC_UNMADE_H
#define REDCC_UNMADE_H

#include "redcc/runtime.h"

#include <stdbool.h>

/** Is `state` null or such an odd word? If not, it is a pointer to a state. */
static inline bool redcc_is_unmade(const void *state) {
    return !state || ((__UINTPTR_TYPE__)state & 1);
}

/** Counts a call of `trip` iterations that executes the original loop. Returns whether to time it.
 */
bool redcc_unmade_call(void **state, redcc_int trip);

/** Records that an execution of `trip` iterations took `seconds`. Returns 0 if the loop is not
 * worth a state yet. Otherwise the caller must create the state. The result is then the number of
 * executions that `seconds` represents: this one, and earlier ones whose time was estimated by
 * it. */
int redcc_unmade_timed(void **state, redcc_int trip, double seconds);

#endif
