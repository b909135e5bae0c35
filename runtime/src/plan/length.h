/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_LENGTH_H
#define REDCC_LENGTH_H

#include "plan/plan.h"

/** The makespan of the plan in iterations, that is, the time of the thread that ends last, if all
 * iterations take equally long and nothing else takes time. It includes the time that threads wait
 * at the end of a stage or for the flag of a task. The stages must be numbered. If memory runs out,
 * returns the largest number of iterations of a thread. */
redcc_int redcc_plan_length(const struct plan *plan);

#endif
