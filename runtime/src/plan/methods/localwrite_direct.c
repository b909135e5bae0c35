/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * LOCALWRITE without access summaries or schedules. Each thread evaluates the slice of all
 * iterations, finds the iterations that touch elements that it owns, and executes them
 * (execute/select.h). The inspection only cuts the arrays according to its sample, and finds
 * extents for the overlap guard.
 *
 * The assignment of iterations and their order are those of LOCALWRITE, so the result has the bits
 * of the sequential loop.
 */
#include "plan/plan.h"

/* Sets the number of iterations to an equal share of the trip count, as if only one thread executed
 * each iteration. The actual number is known only after the execution. */
static bool prepare(struct plan *plan, const struct evidence *evidence, int thread) {
    plan->schedule[thread].iterations = redcc_share(evidence->trip, evidence->threads, thread + 1) -
                                        redcc_share(evidence->trip, evidence->threads, thread);
    return true;
}

const struct method redcc_method_localwrite_direct = {
    .name = "localwrite-direct", .keeps = REDCC_ORDER_SERIAL, .selects = true, .prepare = prepare};
