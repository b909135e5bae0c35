/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/methods/shares.h"

#include "plan/share_count.h"

#include <assert.h>

uint32_t redcc_one_owner(int threads, int parameter) {
    (void)threads;
    (void)parameter;
    return 1;
}

bool redcc_shares_prepare(struct plan *plan, const struct evidence *evidence, int thread) {
    assert(0 <= thread && thread < evidence->threads);
    const redcc_int first = redcc_share(evidence->trip, evidence->threads, thread);
    const redcc_int end = redcc_share(evidence->trip, evidence->threads, thread + 1);
    return redcc_schedule_add(&plan->schedule[thread], 0, first, end - first, false);
}

static redcc_int begin_of(const struct plan *plan, redcc_int trip, uint32_t share) {
    return plan->method->copies == COPY_LATER ? redcc_share_begin(trip, plan->parameter, (int)share)
                                              : redcc_share(trip, plan->parameter, (int)share);
}

bool redcc_fixed_shares_prepare(struct plan *plan, const struct evidence *evidence, int thread) {
    const uint32_t shares = (uint32_t)plan->parameter;
    const uint32_t end = redcc_part_first(shares, evidence->threads, thread + 1);
    uint32_t share = redcc_part_first(shares, evidence->threads, thread);
    bool enough = true;
    for (; enough && share < end; share++) {
        const redcc_int from = begin_of(plan, evidence->trip, share);
        const redcc_int to = begin_of(plan, evidence->trip, share + 1);
        redcc_schedule_into_copy(&plan->schedule[thread], share);
        enough = redcc_schedule_add(&plan->schedule[thread], 0, from, to - from, false);
    }
    return enough;
}
