/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * LOCALWRITE with work stealing. The arrays are cut into equal shares, one for each thread. Each
 * thread owns most of its share; the rest is cut into stealable blocks, which no thread owns.
 * Threads that finish early take these blocks one by one, the larger ones first. So no thread waits
 * long for another thread that had more expensive iterations or lost its core for a while.
 *
 * A block is executed by one thread, in ascending order, so each element gets its contributions in
 * the order of the loop. The price is that an iteration that writes to several parts (threads' own
 * parts or blocks) is executed once for each.
 */
#include "plan/methods/localwrite.h"

static bool prepare(struct plan *plan, const struct evidence *evidence, int thread) {
    const uint32_t own = redcc_own_schedule(plan, thread);
    bool enough = redcc_localwrite_select(plan, evidence, own, thread);
    for (uint32_t block = 1; enough && block <= REDCC_STEALABLE; block++)
        enough = redcc_localwrite_select(plan, evidence, own + block, -1);
    return enough;
}

const struct method redcc_method_localwrite_steal = {.name = "localwrite-steal",
                                                     .alias = "spare-localwrite",
                                                     .keeps = REDCC_ORDER_SERIAL,
                                                     .steals = true,
                                                     .prepare = prepare};

/* Work stealing with owners that are chosen by partitioning the access graph. */
const struct method redcc_method_graph_localwrite_steal = {.name = "graph-localwrite-steal",
                                                           .alias = "spare-graph-localwrite",
                                                           .keeps = REDCC_ORDER_SERIAL,
                                                           .by_graph = true,
                                                           .steals = true,
                                                           .prepare = prepare};
