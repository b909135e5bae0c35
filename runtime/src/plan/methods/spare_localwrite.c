/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * LOCALWRITE with spare parts: each thread owns most of an equal share of the arrays, and what is
 * left of the shares is cut into small parts that belong to no thread. Who is done with his own
 * takes one after the other of these, the larger ones first: so no thread waits long for one that
 * had dearer iterations, or whose core was taken away for a while.
 *
 * Every part is executed whole and in ascending order, by whichever thread: each element gets its
 * contributions in the order of the loop. The price are iterations that write to several parts.
 */
#include "plan/methods/localwrite.h"

static bool prepare(struct plan *plan, const struct evidence *evidence, int thread) {
    const uint32_t own = redcc_own_schedule(plan, thread);
    bool enough = redcc_localwrite_select(plan, evidence, own, thread);
    for (uint32_t spare = 1; enough && spare <= REDCC_SPARES; spare++)
        enough = redcc_localwrite_select(plan, evidence, own + spare, -1);
    return enough;
}

const struct method redcc_method_spare_localwrite = {
    .name = "spare-localwrite", .keeps = REDCC_ORDER_SERIAL, .spares = true, .prepare = prepare};

/* The same with owners cut from the access graph. */
const struct method redcc_method_spare_graph_localwrite = {.name = "spare-graph-localwrite",
                                                           .keeps = REDCC_ORDER_SERIAL,
                                                           .by_graph = true,
                                                           .spares = true,
                                                           .prepare = prepare};
