/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_LOCALWRITE_H
#define REDCC_LOCALWRITE_H

#include "plan/plan.h"

/** Fills the schedule of `thread` with the iterations that touch what it owns, in ascending order;
 *  those that touch others' too are guarded. False: no memory. */
bool redcc_localwrite_prepare(struct plan *plan, const struct evidence *evidence, int thread);

/** The same of one owner: fills schedule[owner]. Where iterations that touch nothing matter, it
 * gets those that thread `idle_of` was told; -1: nobody's. */
bool redcc_localwrite_select(struct plan *plan, const struct evidence *evidence, uint32_t owner,
                             int idle_of);

#endif
