/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loops that nothing has been allocated for. Making a loop's state takes some 40 microseconds, five
 * executions of a loop of 20,000 additions; so it is made when an execution has taken long enough
 * for threads to be worth waking, and often enough. Until then one word, in the place of the
 * pointer to the state, says when the loop is timed again. Any thread may call these functions at
 * any time.
 */
#ifndef REDCC_UNMADE_H
#define REDCC_UNMADE_H

#include "redcc/runtime.h"

#include <stdbool.h>

/** Is this no pointer to a state? */
static inline bool redcc_is_unmade(const void *state) {
    return !state || ((__UINTPTR_TYPE__)state & 1);
}

/** A call of `trip` iterations, which is left to the original loop: counts it, and says whether it
 * is to be timed. */
bool redcc_unmade_call(void **state, redcc_int trip);

/** So many seconds were timed. 0: the loop is not worth a state. Else it is, and they stand for so
 *  many executions: this one, and as many before it as were counted at least. */
int redcc_unmade_timed(void **state, redcc_int trip, double seconds);

#endif
