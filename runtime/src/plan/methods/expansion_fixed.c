/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Array expansion with N copies for any number of threads: the iterations are divided into N equal
 * shares, each with a copy of the whole array, and the copies are merged in order. The same bits at
 * every thread count; at most N threads are busy.
 */
#include "plan/methods/shares.h"

#include <stdlib.h>

enum { USUAL = 16, MOST = 1024 };

static int parse(const char *text) {
    char *end;
    const long copies = strtol(text, &end, 10);
    return end != text && *end == '\0' && copies >= 1 && copies <= MOST ? (int)copies : 0;
}

static bool prepare(struct plan *plan, const struct evidence *evidence, int thread) {
    const uint32_t copies = (uint32_t)plan->parameter;
    const uint32_t end = redcc_part_first(copies, evidence->threads, thread + 1);
    uint32_t copy = redcc_part_first(copies, evidence->threads, thread);
    bool enough = true;
    for (; enough && copy < end; copy++) {
        const redcc_int from = redcc_share(evidence->trip, (int)copies, (int)copy);
        const redcc_int to = redcc_share(evidence->trip, (int)copies, (int)copy + 1);
        redcc_schedule_into_copy(&plan->schedule[thread], copy);
        enough = redcc_schedule_add(&plan->schedule[thread], 0, from, to - from, false);
    }
    return enough;
}

const struct method redcc_method_expansion_fixed = {.name = "expansion-fixed",
                                                    .parameter = "N",
                                                    .keeps = REDCC_ORDER_FIXED,
                                                    .copies = COPY_SHARE,
                                                    .parse = parse,
                                                    .usual = USUAL,
                                                    .owners = redcc_one_owner,
                                                    .prepare = prepare};
