/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/prefetch.h"

/* Second-level caches of today's cores hold 0.25 to 2 MiB; what lies there is fetched while other
 * operations go on, without being asked for. */
enum { LEAST_BYTES = 1 << 20 };

/* with, without, without, with, with, without: what changes slowly favours neither. */
enum { TRIAL = 6, FIRST_REST = 64, LONGEST_REST = 4096 };

static bool is_tried_with(unsigned timed) {
    return (timed + 1) / 2 % 2 == 0;
}

bool redcc_prefetch_begins(const struct prefetching *it, enum prefetch_setting setting) {
    if (setting != PREFETCH_AUTO)
        return setting == PREFETCH_ON;
    return it->rest > 0 ? !it->is_worse : is_tried_with(it->timed);
}

bool redcc_prefetch_is_possible(const struct plan *plan) {
    return plan->copies.count == 0; /* the slice computes addresses in the arrays themselves */
}

bool redcc_prefetch_is_of_use(const struct plan *plan) {
    ptrdiff_t bytes = 0;
    for (uint32_t group = 0; group < plan->array_count; group++)
        if (plan->touched[group].end > plan->touched[group].first)
            bytes += plan->touched[group].end - plan->touched[group].first;
    return bytes > LEAST_BYTES && redcc_prefetch_is_possible(plan);
}

static void end_trial(struct prefetching *it) {
    it->is_worse = it->least[0] < it->least[1];
    it->interval = it->interval ? it->interval * 2 : FIRST_REST;
    it->interval = it->interval > LONGEST_REST ? LONGEST_REST : it->interval;
    it->rest = it->interval;
    it->timed = 0;
    it->least[0] = it->least[1] = 0;
}

void redcc_prefetch_note(struct prefetching *it, bool prefetched, double seconds_an_iteration) {
    if (it->rest > 0) {
        it->rest--;
        return;
    }
    double *least = &it->least[prefetched];
    *least = *least > 0 && *least < seconds_an_iteration ? *least : seconds_an_iteration;
    if (++it->timed == TRIAL)
        end_trial(it);
}
