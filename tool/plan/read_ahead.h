/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Decides what may be read before the first iteration. */
#ifndef PLAN_READ_AHEAD_H
#define PLAN_READ_AHEAD_H

#include "plan/plan.h"

/** Records an obstacle if an expression needed before the first iteration is not certain to be
 *  evaluated by the loop itself. Sets has_ready_base. */
void plan_reads_ahead(loop_plan *plan);

#endif
