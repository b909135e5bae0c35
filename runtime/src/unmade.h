/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loops that have no state yet. Creating a loop's state takes some 40 microseconds, as long as five
 * executions of a loop of 20,000 additions. So the state is created only after enough executions
 * were so long that it is worth waking threads for them. Until then, loop->state has an odd word in
 * place of the pointer. This word determines when the loop is timed next. Thread-safe.
 */
#ifndef REDCC_UNMADE_H
#define REDCC_UNMADE_H

#include "redcc/runtime.h"

#include <stdbool.h>

/** Is `state` null or such a word, not a pointer to a state? */
static inline bool redcc_is_unmade(const void *state) {
    return !state || ((__UINTPTR_TYPE__)state & 1);
}

/** Counts a call of `trip` iterations that executes the original loop. Returns whether to time it.
 */
bool redcc_unmade_call(void **state, redcc_int trip);

/** Records a timing. 0: the loop is not worth a state yet. Otherwise the caller must create the
 * state. The result is then the number of executions that the timing represents: this one and the
 * executions before it whose time was counted. */
int redcc_unmade_timed(void **state, redcc_int trip, double seconds);

#endif
