/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Compensated sums of floats and doubles, by the method of Neumaier (Zeitschrift fuer angewandte
 * Mathematik und Mechanik 54, 1974). The rounding errors of each element are accumulated in double,
 * and their sum is added to the element at the end of the loop.
 *
 * A contribution is rounded to the element's type before it is added. If an element is infinite or
 * NaN, its error is not added, so that it has the value of the plain sum.
 */
#ifndef REDCC_COMPENSATE_H
#define REDCC_COMPENSATE_H

#include "plan/plan.h"
#include "plan/rounding.h"

/** Clears the errors of this thread's share of the elements of the arrays at `bases`. */
void redcc_rounding_clear(const struct plan *plan, int thread, void *const *bases);

/** Adds the errors of this thread's share of the elements to the arrays. */
void redcc_rounding_add(const struct plan *plan, int thread);

/** Called before the `count` elements at `address` are updated, each at most once. Saves their
 * values and sets them to the neutral element. */
void redcc_rounding_begin(const struct rounding *rounding, void *address, size_t count);

/** Called after the update, when the elements hold contributions. Adds these to the saved values,
 * and accumulates the errors. */
void redcc_rounding_end(const struct rounding *rounding, void *address, size_t count);

#endif
