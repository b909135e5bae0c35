/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Decides whether executions of a loop can prefetch the accesses of later iterations, and whether
 *  that pays. */
#ifndef REDCC_EXECUTE_PREFETCH_H
#define REDCC_EXECUTE_PREFETCH_H

#include "plan/plan.h"

#include <stdbool.h>

/** The values of REDCC_PREFETCH. */
enum prefetch_setting {
    PREFETCH_OFF,
    PREFETCH_AUTO, /* prefetches are used if trials show that they pay (variant.h) */
    PREFETCH_ON    /* prefetches are used whenever the loop and the plan permit them */
};

/** Are prefetches possible with this plan? Only if it writes to the arrays themselves. */
bool redcc_prefetch_is_possible(const struct plan *plan);

/** May prefetches pay with this plan? They must be possible, and the updated ranges must have more
 * than 1 MiB together. For loops of short iterations (`is_light`), they must have more than 8 MiB,
 * and accesses must be irregular. */
bool redcc_prefetch_is_of_use(const struct plan *plan, bool is_light);

#endif
