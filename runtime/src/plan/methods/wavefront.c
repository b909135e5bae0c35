/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Order-preserving wavefronts: executes the levels of iterations (ownership/graph/levels.h) one
 * after the other. Each level is distributed evenly over the threads, but levels of few iterations
 * are executed by one thread. No iteration is owner-checked or executed twice. If two iterations
 * touch a common element, the earlier one is in an earlier level. The two levels are separated by a
 * barrier, or one thread executes both in the order of the loop. So each element gets its
 * contributions in the order of the loop.
 */
#include "ownership/graph/levels.h"
#include "plan/methods/shares.h"

static bool prepare(struct plan *plan, const struct evidence *evidence, int thread) {
    const struct levels *levels = evidence->levels;
    struct schedule *schedule = &plan->schedule[thread];
    for (uint32_t stage = 0; stage < levels->stages; stage++) {
        uint32_t first, end;
        redcc_levels_share(levels, stage, plan->threads, thread, &first, &end);
        for (uint32_t i = first; i < end; i++)
            if (!redcc_schedule_add(schedule, stage, levels->iteration[i], 1, false))
                return false;
    }
    redcc_schedule_finish(schedule);
    return true;
}

const struct method redcc_method_wavefront = {.name = "wavefront",
                                              .keeps = REDCC_ORDER_SERIAL,
                                              .by_graph = true,
                                              .in_levels = true,
                                              .owners = redcc_one_owner,
                                              .prepare = prepare};
