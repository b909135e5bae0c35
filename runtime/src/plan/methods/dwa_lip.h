/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_DWA_LIP_H
#define REDCC_DWA_LIP_H

#include "plan/plan.h"

/**
 * Fills the schedule of `thread` for DWA-LIP (dwa_lip.c) within its team. The thread gets those of
 * the iterations inspected by the team's threads whose lowest block belongs to it. The schedule has
 * the stages of figure 10 of the paper (docs/paper.md). Returns false if out of memory.
 */
bool redcc_dwa_lip_prepare(struct plan *plan, const struct evidence *evidence, int thread);

/** Called with the iterations from `begin` to before `begin` + `count`. `lowest` is the lowest
 * block that they write, and `lowest` + `delta` the highest. Returns false if out of memory. */
typedef bool redcc_pair_taker(void *context, uint32_t lowest, uint32_t delta, redcc_int begin,
                              redcc_int count);

/** Passes the iterations that thread `from` has inspected to `take`, in order, with the pair (Bmin,
 * deltaB) of the blocks that they write. Iterations that write no block are left out or, with
 * evidence.every_iteration, passed with block 0. Returns false if `take` returned false. */
bool redcc_visit_pairs(const struct evidence *evidence, int from, redcc_pair_taker *take,
                       void *context);

#endif
