/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/prefetch.h"

/* Second-level caches of today's cores hold 0.25 to 2 MiB; what lies there is fetched while other
 * operations go on, without being asked for. */
enum { LEAST_BYTES = 1 << 20 };

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
