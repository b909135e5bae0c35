/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** From what is asked for, what a loop has and what is known of it to the manner of an execution.
 */
#include "execute/run.h"

void redcc_run_choose_manner(struct run *run, struct manners *known) {
    const struct call *call = run->call;
    const unsigned flags = call->request.loop->flags;
    struct chosen_manner *it = &run->manner;
    const int width = redcc_lanes_width(flags, (enum lanes_setting)call->lanes, &it->why);
    unsigned asked = width > 0 && it->why == LANES_SAID ? WITH_LANES : 0;
    it->open = width > 0 && it->why == LANES_TRYING ? WITH_LANES : 0;
    if (flags & (REDCC_PREFETCHES | REDCC_LIGHT)) {
        asked |= call->prefetch == PREFETCH_ON ? WITH_PREFETCH : 0;
        it->open |= call->prefetch == PREFETCH_AUTO ? WITH_PREFETCH : 0;
    }
    it->taken = asked | redcc_manner_begins(known, it->open);
    it->lanes = it->taken & WITH_LANES ? width : 0;
}

static bool is_of_use(const struct run *run, const struct plan *plan) {
    return redcc_prefetch_is_of_use(plan, run->call->request.loop->flags & REDCC_LIGHT);
}

redcc_manner redcc_run_manner(const struct run *run, const struct plan *plan) {
    const bool is_asked = run->call->prefetch == PREFETCH_ON;
    const bool prefetches = run->manner.taken & WITH_PREFETCH &&
                            (is_asked ? redcc_prefetch_is_possible(plan) : is_of_use(run, plan));
    return (redcc_manner){prefetches, run->manner.lanes};
}

enum lanes_reason redcc_run_note_manner(const struct run *run, struct manners *known,
                                        double seconds_an_iteration) {
    const struct chosen_manner *it = &run->manner;
    const unsigned of_use = WITH_LANES | (is_of_use(run, run->plan) ? WITH_PREFETCH : 0);
    redcc_manner_note(known, it->open, of_use, it->taken & it->open, seconds_an_iteration);
    if (it->why != LANES_TRYING || known->rest == 0)
        return it->why;
    return known->best & WITH_LANES ? LANES_FASTER : LANES_SLOWER;
}
