/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_SHARES_H
#define REDCC_SHARES_H

#include "plan/plan.h"

/** Fills the schedule of `thread` with an equal share of the iterations. False: no memory. */
bool redcc_shares_prepare(struct plan *plan, const struct evidence *evidence, int thread);

/** The iterations in plan->parameter equal shares, in order; `thread` gets its part of them, each
 * into the copy of its number. The same shares at every number of threads. */
bool redcc_fixed_shares_prepare(struct plan *plan, const struct evidence *evidence, int thread);

/** struct method.owners for methods that ignore ownership: a single owner. The inspection then has
 *  nothing to distinguish, and takes a fraction of the time on shuffled data. */
uint32_t redcc_one_owner(int threads, int parameter);

#endif
