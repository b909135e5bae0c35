/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_DWA_LIP_H
#define REDCC_DWA_LIP_H

#include "plan/plan.h"

/**
 * Fills the schedule of `thread` for DWA-LIP within its team. Of the iterations that the team's
 * threads inspected, it gets those whose lowest block belongs to it, in the stages of figure 10 of
 * the paper. False: no memory.
 */
bool redcc_dwa_lip_prepare(struct plan *plan, const struct evidence *evidence, int thread);

/** Called with iterations [begin, begin + count), whose lowest written block is `lowest` and
 * highest `lowest` + `delta`. False: out of memory. */
typedef bool redcc_pair_taker(void *context, uint32_t lowest, uint32_t delta, redcc_int begin,
                              redcc_int count);

/** Passes the iterations that thread `from` has inspected to `take` in order, with the pair
 *  (Bmin, deltaB) of the blocks that they write. Those that write none are left out, or executed
 *  with block 0 (evidence.every_iteration). False: `take` returned false. */
bool redcc_visit_pairs(const struct evidence *evidence, int from, redcc_pair_taker *take,
                       void *context);

#endif
