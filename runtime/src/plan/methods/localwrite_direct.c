/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * LOCALWRITE without access summaries or schedules: each thread goes through all iterations, finds
 * by their index part which of them touch what it owns, and executes these (execute/select.h). The
 * inspection cuts the arrays by its sample, and finds extents for the overlap guard.
 *
 * Who executes what is what LOCALWRITE says, in the same order: the bits of the sequential loop.
 */
#include "plan/plan.h"

/* As many as if none were replicated; how many there are is known after the execution. */
static bool prepare(struct plan *plan, const struct evidence *evidence, int thread) {
    plan->schedule[thread].iterations = redcc_share(evidence->trip, evidence->threads, thread + 1) -
                                        redcc_share(evidence->trip, evidence->threads, thread);
    return true;
}

const struct method redcc_method_localwrite_direct = {
    .name = "localwrite-direct", .keeps = REDCC_ORDER_SERIAL, .selects = true, .prepare = prepare};
