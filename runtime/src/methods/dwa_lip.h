/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_DWA_LIP_H
#define REDCC_DWA_LIP_H

#include "plan.h"

/**
 * Fills the schedule of `thread` for DWA-LIP within its team: of the iterations that the team's
 * threads inspected, those whose lowest block this thread is in charge of, in the stages of figure
 * 10 of the paper. False: no memory.
 */
bool redcc_dwa_lip_prepare(struct plan *plan, const struct evidence *evidence, int thread);

#endif
