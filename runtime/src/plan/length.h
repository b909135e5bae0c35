/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_LENGTH_H
#define REDCC_LENGTH_H

#include "plan/plan.h"

/** How long the plan's threads take, in iterations of the loop, each being as long as any other and
 *  all else taking no time: threads that wait for others at the end of a stage, or for a task's
 *  flag, are idle meanwhile. To be asked when the stages are numbered. Where there is no memory for
 *  the estimate: the iterations of the thread that has most. */
redcc_int redcc_plan_length(const struct plan *plan);

#endif
