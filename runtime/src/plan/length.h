/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_LENGTH_H
#define REDCC_LENGTH_H

#include "plan/plan.h"

/** The makespan of the plan, in iterations of equal length, without other costs; includes idle time
 *  at the end of a stage, or while a task's flag is awaited. The stages must be numbered. If out of
 *  memory, returns the largest number of iterations of a thread. */
redcc_int redcc_plan_length(const struct plan *plan);

#endif
