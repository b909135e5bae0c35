/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Chooses the variant of an execution from the settings, the loop's forms and earlier results. */
#include "execute/run.h"

#include <assert.h>

void redcc_run_choose_variant(struct run *run, const struct variants *known) {
    const struct call *call = run->call;
    const unsigned flags = call->request.loop->flags;
    struct variant_choice *it = &run->variant;
    const bool can_prefetch = flags & (REDCC_PREFETCHES | REDCC_LIGHT);
    it->known = known;
    it->lanes = redcc_lanes_width(flags, (enum lanes_setting)call->lanes, &it->why);
    it->is_asked = can_prefetch && call->prefetch == PREFETCH_ON;
    it->is_open = can_prefetch && call->prefetch == PREFETCH_AUTO;
}

/* Is the choice open, and does it matter for an execution with the plan? */
static bool is_open_with(const struct run *run, const struct plan *plan) {
    return run->variant.is_open &&
           redcc_prefetch_is_of_use(plan, run->call->request.loop->flags & REDCC_LIGHT);
}

unsigned redcc_run_parts(const struct run *run, const struct plan *plan) {
    assert(plan->threads >= 1);
    return redcc_variant_parts(run->variant.known, is_open_with(run, plan) && !plan->method->tiles,
                               plan->executed / plan->threads);
}

redcc_variant redcc_run_variant(const struct run *run, const struct plan *plan, unsigned part) {
    const struct variant_choice *it = &run->variant;
    assert(redcc_is_fixed(run->call) == (plan->method == &redcc_method_sections));
    const bool prefetches = (it->is_asked && redcc_prefetch_is_possible(plan)) ||
                            redcc_variant_of(it->known, is_open_with(run, plan), part);
    return (redcc_variant){
        .prefetches = prefetches, .lanes = it->lanes, .operands = redcc_call_operands(run->call)};
}

void redcc_run_note_variant(const struct run *run, struct variants *known, const double *seconds,
                            const double *iterations) {
    const unsigned parts = redcc_run_parts(run, run->plan);
    assert(parts <= VARIANT_PARTS);
    double each[VARIANT_PARTS];
    for (unsigned part = 0; part < parts; part++)
        each[part] = iterations[part] > 0 ? seconds[part] / iterations[part] : 0;
    redcc_variant_note(known, is_open_with(run, run->plan), parts, each);
}
