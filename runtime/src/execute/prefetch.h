/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Can executions of a loop prefetch what iterations to come touch, and is it of use? */
#ifndef REDCC_EXECUTE_PREFETCH_H
#define REDCC_EXECUTE_PREFETCH_H

#include "plan/plan.h"

#include <stdbool.h>

/** What REDCC_PREFETCH says. */
enum prefetch_setting {
    PREFETCH_OFF,
    PREFETCH_AUTO, /* where it has been found to pay (manner.h) */
    PREFETCH_ON    /* wherever the loop can */
};

/** Can it be done with this plan: are the arrays written where they are? */
bool redcc_prefetch_is_possible(const struct plan *plan);

/** Can it pay with this plan: is it possible, and do the arrays not fit in a core's caches? Of
 *  light iterations, not in the cores' common cache either, and do they come in no order? */
bool redcc_prefetch_is_of_use(const struct plan *plan, bool is_light);

#endif
