/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_LOCALWRITE_H
#define REDCC_LOCALWRITE_H

#include "plan/plan.h"

/** Fills the schedule of `thread` with the iterations that touch elements that it owns, in
 * ascending order. Iterations that also touch elements of other owners are owner-checked. Returns
 * false if out of memory. */
bool redcc_localwrite_prepare(struct plan *plan, const struct evidence *evidence, int thread);

/** As redcc_localwrite_prepare, for one owner: fills schedule[owner]. If iterations that touch
 * nothing must be executed, the owner also gets those that thread `idle_of` has inspected; idle_of
 * == -1: none. */
bool redcc_localwrite_select(struct plan *plan, const struct evidence *evidence, uint32_t owner,
                             int idle_of);

#endif
