/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Compensated sums of floats and doubles, by Neumaier (Zeitschrift fuer angewandte Mathematik und
 * Mechanik 54, 1974): beside each element stands what was lost in rounding it, added up in double
 * and brought in at the end of the loop.
 *
 * A contribution is taken as an element of that type. Where a sum is infinite or no number, nothing
 * is brought in: the element is what the plain sum gives.
 */
#ifndef REDCC_COMPENSATE_H
#define REDCC_COMPENSATE_H

#include "plan/lost.h"
#include "plan/plan.h"

/** Nothing is lost yet: of the elements that are this thread's share, for arrays at `bases`. */
void redcc_lost_clear(const struct plan *plan, int thread, void *const *bases);

/** Brings what was lost of this thread's share into the arrays. */
void redcc_lost_bring(const struct plan *plan, int thread);

/** The `count` elements at `address` may be updated, each once: keeps what they hold, and sets them
 *  to the neutral element. */
void redcc_lost_begin(const struct lost *lost, void *address, size_t count);

/** Those that were hold a contribution now: adds it to what they held, and keeps what is lost. */
void redcc_lost_end(const struct lost *lost, void *address, size_t count);

#endif
