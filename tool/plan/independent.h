/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Loops whose OpenMP directives say that an iteration reads nothing that another one updates. */
#ifndef PLAN_INDEPENDENT_H
#define PLAN_INDEPENDENT_H

#include "plan/plan.h"

/**
 * Has each read that the guard would compare, and whose address is known only during execution, the
 * value from before the loop?
 *
 * `atomic` does not protect these reads. If another iteration updated what is read, the
 * program would have a data race, because any two iterations may be executed by different threads.
 * So only the iteration itself may update it, and must do so after the read: every such read
 * precedes the first update, or is an operand of it.
 *
 * False if a clause may give all iterations, or chosen ones, to a single thread: `if`,
 * `num_threads`, `schedule(static)`; or if a region around the loop might do so. Also false if the
 * loop has a `critical` section, which may protect reads.
 */
bool reads_are_independent(const loop_plan *plan);

#endif
