/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_SHARES_H
#define REDCC_SHARES_H

#include "plan/plan.h"

/** Fills the schedule of `thread` with an equal share of the iterations. False: out of memory. */
bool redcc_shares_prepare(struct plan *plan, const struct evidence *evidence, int thread);

/** Divides the iterations into plan->parameter equal shares; this division does not depend on the
 * number of threads. `thread` gets some consecutive shares. It executes them in order, each with
 * the share's own copy. Returns false if out of memory. */
bool redcc_fixed_shares_prepare(struct plan *plan, const struct evidence *evidence, int thread);

/** The function `owners` of methods that ignore ownership: returns 1. The inspection then need not
 * distinguish owners, and is much faster on shuffled data. */
uint32_t redcc_one_owner(int threads, int parameter);

#endif
