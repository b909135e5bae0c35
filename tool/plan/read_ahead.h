/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What is read before the first iteration. */
#ifndef PLAN_READ_AHEAD_H
#define PLAN_READ_AHEAD_H

#include "plan/plan.h"

/** Records an obstacle where something that must be evaluated before the first iteration is not
 * certain to be evaluated by the loop itself. Sets has_ready_base. */
void plan_reads_ahead(loop_plan *plan);

#endif
