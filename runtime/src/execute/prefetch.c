/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/prefetch.h"

/* Prefetches do not help if arrays are smaller than this number of bytes. The second-level caches
 * of current cores have 0.25 to 2 MiB, and accesses to them overlap with other operations. */
enum { LEAST_BYTES = 1 << 20 };

/* The same limit for loops of short iterations. With random updates, they were faster with
 * prefetches if arrays had 10 MB, and slower if they had 5 MB (script/bench lanes, SIDE=650 and
 * 467). The machine's shared cache has 32 MiB, but it also holds the data that are read. */
enum { LEAST_BYTES_LIGHT = 8 << 20 };

/* Accesses count as irregular if runs have fewer iterations than this on average. */
enum { SHORT_RUN = 4 };

bool redcc_prefetch_is_possible(const struct plan *plan) {
    /* the slice computes addresses in the arrays, not in the copies */
    return plan->copies.count == 0;
}

static ptrdiff_t bytes_updated(const struct plan *plan) {
    ptrdiff_t bytes = 0;
    for (uint32_t group = 0; group < plan->array_count; group++)
        if (plan->touched[group].end > plan->touched[group].first)
            bytes += plan->touched[group].end - plan->touched[group].first;
    return bytes;
}

static bool is_in_no_order(const struct plan *plan) {
    size_t iterations = 0, runs = 0;
    for (uint32_t s = 0; s < plan->schedules; s++) {
        iterations += (size_t)plan->schedule[s].iterations;
        runs += plan->schedule[s].run_count;
    }
    return iterations < SHORT_RUN * runs;
}

bool redcc_prefetch_is_of_use(const struct plan *plan, bool is_light) {
    return redcc_prefetch_is_possible(plan) &&
           bytes_updated(plan) > (is_light ? LEAST_BYTES_LIGHT : LEAST_BYTES) &&
           (!is_light || is_in_no_order(plan));
}
