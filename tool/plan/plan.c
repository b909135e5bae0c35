/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/plan.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>

#include "analysis/base/distributed.h"
#include "analysis/base/loop_exits.h"
#include "analysis/base/loop_loads.h"
#include "plan/bins.h"
#include "plan/execution.h"
#include "plan/inner_iterations.h"
#include "plan/lanes.h"
#include "plan/lookup.h"
#include "plan/outline.h"
#include "plan/precheck.h"
#include "plan/prefetch.h"
#include "plan/read_ahead.h"
#include "plan/rewritable.h"
#include "plan/sections.h"
#include "plan/sources.h"
#include "plan/stand_in.h"
#include "plan/tiles.h"

void plan_obstacle(loop_plan *plan, ir_range range, const char *format, ...) {
    if (plan->obstacle.message)
        return;
    char text[256];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    plan->obstacle = (reason){.message = arena_string(plan->arena, text), .range = range};
}

static void plan_stand_ins(loop_plan *plan) {
    const loop_facts *facts = plan->facts;
    bool *is_shadowed = ARENA_ARRAY(plan->arena, bool, facts->array_count + 1);
    for (unsigned i = 0; i < facts->array_count; i++)
        is_shadowed[i] =
            !facts->arrays[i].is_scattered && can_be_shadowed(plan, facts->arrays[i].base);
    plan->is_shadowed = is_shadowed;
}

static void plan_form(loop_plan *plan) {
    assert(!plan->obstacle.message && plan->has_ready_base);
    const loop_facts *facts = plan->facts;
    plan_stand_ins(plan);
    plan_execution(plan);
    plan->execution.sections = plan_sections(plan);
    if (plan->execution.sections && plan->execution.order == ORDER_SERIAL)
        plan->execution.order = ORDER_FIXED;
    const char *obstacle = plan_outline(plan);
    if (obstacle)
        plan_obstacle(plan, facts->loop->range, "%s", obstacle);
    plan_prefetch(plan);
    plan_inner_skips(plan); /* before the bins: a loop in which one thread leads has no spans
                             * (bins_span.c) */
    if (leaves_variables(facts))
        plan->no_bins = "the loop has live-out variables as well as updates";
    else
        plan_bins(plan);
    assert((plan->bins == NULL) == (plan->no_bins != NULL));
    plan_unordered(plan);
    if (plan->execution.is_unordered && plan->execution.order == ORDER_SERIAL)
        plan->execution.order = ORDER_FIXED;
    plan->no_lanes = plan_lanes(plan);
    plan_tiles(plan);
    if (!facts->inspector.exists && !plan->bins) {
        plan_obstacle(plan, facts->loop->range, "%s", plan->no_bins);
        plan->obstacle.id = REASON_INDEX_EXPENSIVE;
    }
}

const loop_plan *plan_loop(arena *a, const ir_unit *whole, const ir_unit *unit,
                           const loop_facts *facts, const plan_options *options) {
    assert(options->order <= ORDER_ANY && ir_is_loop(facts->loop));
    loop_plan *plan = ARENA_NEW(a, loop_plan);
    *plan =
        (loop_plan){.arena = a, .whole = whole, .unit = unit, .facts = facts, .options = options};
    distributed_take_out(facts->distribution);
    loop_exits_take_out(facts->slice.exits);
    loop_loads_take_out(facts->variables.loads);
    plan_sources(plan);
    check_place(plan);
    plan_reads_ahead(plan);
    plan_precheck(plan);
    check_iterations(plan);
    if (!plan->obstacle.message)
        plan_form(plan);
    loop_loads_put_back(facts->variables.loads);
    loop_exits_put_back(facts->slice.exits);
    distributed_put_back(facts->distribution);
    return plan;
}
