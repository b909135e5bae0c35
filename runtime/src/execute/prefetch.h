/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Do executions of a loop prefetch what iterations to come touch? Both ways give the same bits, so
 * that the first executions are timed each way in turn, and the better way is kept for a while.
 */
#ifndef REDCC_EXECUTE_PREFETCH_H
#define REDCC_EXECUTE_PREFETCH_H

#include "plan/plan.h"

#include <stdbool.h>

/** What REDCC_PREFETCH says. */
enum prefetch_setting {
    PREFETCH_OFF,
    PREFETCH_AUTO, /* where it has been found to pay */
    PREFETCH_ON    /* wherever the loop can */
};

/** What is known of a loop over its executions. All zero: nothing. */
struct prefetching {
    unsigned timed;    /* executions of the trial under way */
    double least[2];   /* seconds an iteration, of the trial: without, with; 0: none yet */
    bool is_worse;     /* by the last trial */
    unsigned rest;     /* executions until the next trial */
    unsigned interval; /* between the last two trials */
};

/** Shall the execution that begins prefetch? One thread at a time. */
bool redcc_prefetch_begins(const struct prefetching *it, enum prefetch_setting setting);

/** Can it be done with this plan: are the arrays written where they are? */
bool redcc_prefetch_is_possible(const struct plan *plan);

/** Can it pay with this plan: is it possible, and do the arrays not fit in a core's caches? */
bool redcc_prefetch_is_of_use(const struct plan *plan);

/** An execution by a plan for which it is of use is over. One thread at a time. */
void redcc_prefetch_note(struct prefetching *it, bool prefetched, double seconds_an_iteration);

#endif
