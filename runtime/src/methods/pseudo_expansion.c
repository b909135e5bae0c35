/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Pseudo-expansion: as array expansion, but a thread's copy is of the range that its own iterations
 * touch, which the inspector found out.
 */
#include "plan.h"

static bool prepare(struct plan *plan, const struct evidence *evidence, int thread) {
    const redcc_int first = redcc_share(evidence->trip, evidence->threads, thread);
    const redcc_int end = redcc_share(evidence->trip, evidence->threads, thread + 1);
    return redcc_schedule_add(&plan->schedule[thread], 0, first, end - first, false);
}

const struct method redcc_method_pseudo_expansion = {.name = "pseudo-expansion",
                                                     .keeps = REDCC_ORDER_ANY,
                                                     .copies = COPY_TOUCHED,
                                                     .prepare = prepare};
