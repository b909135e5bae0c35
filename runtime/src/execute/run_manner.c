/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** From what is asked for, what a loop has and what is known of it to the manner of an execution.
 */
#include "execute/run.h"

void redcc_run_choose_manner(struct run *run, const struct manners *known) {
    const struct call *call = run->call;
    const unsigned flags = call->request.loop->flags;
    struct manner_choice *it = &run->manner;
    it->known = known;
    it->lanes = redcc_lanes_width(flags, (enum lanes_setting)call->lanes, &it->why);
    it->asked = it->lanes > 0 && it->why == LANES_SAID ? WITH_LANES : 0;
    it->open = it->lanes > 0 && it->why == LANES_TRYING ? WITH_LANES : 0;
    it->open |= it->open && redcc_lanes_half(flags, it->lanes) ? WITH_HALF : 0;
    if (flags & (REDCC_PREFETCHES | REDCC_LIGHT)) {
        it->asked |= call->prefetch == PREFETCH_ON ? WITH_PREFETCH : 0;
        it->open |= call->prefetch == PREFETCH_AUTO ? WITH_PREFETCH : 0;
    }
}

/* What makes a difference to an execution with the plan, of what is to be found out. */
static unsigned open_with(const struct run *run, const struct plan *plan) {
    const unsigned flags = run->call->request.loop->flags, open = run->manner.open;
    if (!(open & WITH_PREFETCH) || redcc_prefetch_is_of_use(plan, flags & REDCC_LIGHT))
        return open;
    return open & ~(unsigned)WITH_PREFETCH;
}

unsigned redcc_run_parts(const struct run *run, const struct plan *plan) {
    return redcc_manner_parts(run->manner.known, open_with(run, plan),
                              plan->executed / plan->threads);
}

static int lanes_of(const struct manner_choice *it, unsigned manner) {
    return !(manner & WITH_LANES) ? 0 : manner & WITH_HALF ? it->lanes / 2 : it->lanes;
}

redcc_manner redcc_run_manner(const struct run *run, const struct plan *plan, unsigned part) {
    const struct manner_choice *it = &run->manner;
    const unsigned asked =
        redcc_prefetch_is_possible(plan) ? it->asked : it->asked & ~(unsigned)WITH_PREFETCH;
    const unsigned manner = asked | redcc_manner_of(it->known, open_with(run, plan), part);
    return (redcc_manner){manner & WITH_PREFETCH, lanes_of(it, manner), 0};
}

enum lanes_reason redcc_run_note_manner(const struct run *run, struct manners *known,
                                        const double *seconds, const double *iterations,
                                        int *lanes) {
    const struct manner_choice *it = &run->manner;
    const unsigned parts = redcc_run_parts(run, run->plan);
    double each[MANNER_PARTS];
    for (unsigned part = 0; part < parts; part++)
        each[part] = iterations[part] > 0 ? seconds[part] / iterations[part] : 0;
    redcc_manner_note(known, open_with(run, run->plan), parts, each);
    const bool is_tried = it->why == LANES_TRYING && known->executions < known->rest.until;
    const bool is_faster = known->best & WITH_LANES;
    *lanes = is_tried ? lanes_of(it, known->best) : it->lanes;
    return !is_tried ? it->why : is_faster ? LANES_FASTER : LANES_SLOWER;
}
