/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Decides whether executions of a loop can prefetch the accesses of later iterations, and whether
 *  that pays. */
#ifndef REDCC_EXECUTE_PREFETCH_H
#define REDCC_EXECUTE_PREFETCH_H

#include "plan/plan.h"

#include <stdbool.h>

/** Values of REDCC_PREFETCH. */
enum prefetch_setting {
    PREFETCH_OFF,
    PREFETCH_AUTO, /* if trials show that it pays (variant.h) */
    PREFETCH_ON    /* whenever loop and plan permit it */
};

/** Is it possible with this plan: does it write to the arrays directly? */
bool redcc_prefetch_is_possible(const struct plan *plan);

/** Can it pay with this plan: is it possible, and are the arrays larger than a core's caches? For
 * light iterations: are they also larger than a share of the shared cache, with irregular accesses?
 */
bool redcc_prefetch_is_of_use(const struct plan *plan, bool is_light);

#endif
