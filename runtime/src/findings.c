/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** auto, once a loop is inspected: what was found of it, and the way that follows. */
#include "inspect.h"

#include "budget.h"
#include "memory.h"
#include "settings.h"
#include "system.h"

/* The same bits in whatever order the contributions come? */
static bool any_order_is_exact(const redcc_loop *loop) {
    for (uint32_t array = 0; array < loop->array_count; array++)
        if (loop->arrays[array].type > REDCC_UINT64)
            return false;
    return true;
}

static bool memory_allows(size_t bytes) {
    const size_t limit = redcc_settings()->memory_limit, used = redcc_memory_in_use();
    if (limit)
        return used < limit && bytes < limit - used;
    const uint64_t there = redcc_system_memory();
    return there == 0 || bytes < there / 4;
}

/* How often an iteration touches other owners than the one before it, in all threads' shares. */
static double count_runs(const struct execution *execution) {
    size_t runs = 0;
    for (int thread = 0; thread < execution->threads; thread++)
        runs += execution->state->member[thread]->sweep.summary.span_count;
    return (double)runs;
}

static redcc_int executed_by(const struct execution *execution, uint32_t owner) {
    redcc_int sum = 0;
    for (int thread = 0; thread < execution->threads; thread++)
        sum += execution->state->member[thread]->executed[owner];
    return sum;
}

redcc_int redcc_executed_in_all(const struct execution *execution) {
    redcc_int sum = 0;
    for (uint32_t owner = 0; owner < execution->partition.owners; owner++)
        sum += executed_by(execution, owner);
    return sum;
}

double redcc_largest_share(const struct execution *execution) {
    const struct partition *partition = &execution->partition;
    redcc_int most = 0;
    for (uint32_t owner = 0; owner < partition->owners; owner++) {
        const redcc_int executed = executed_by(execution, owner);
        most = executed > most ? executed : most;
    }
    const double even =
        partition->spares ? (double)redcc_executed_in_all(execution) / execution->threads : 0;
    return (even > (double)most ? even : (double)most) / (double)execution->request.trip;
}

bool redcc_copies_allowed(const struct execution *execution) {
    return redcc_copies_possible(&execution->partition, execution->touched) &&
           memory_allows(redcc_copy_bytes(&execution->partition, execution->touched) *
                         (size_t)execution->threads);
}

/* What is known by the sample and by all iterations alike. */
static struct findings begin_findings(const struct execution *execution) {
    const redcc_loop *loop = execution->request.loop;
    const bool free_order = execution->order == REDCC_ORDER_ANY || any_order_is_exact(loop);
    return (struct findings){
        .trip = execution->request.trip,
        .threads = execution->threads,
        .touches = execution->touches * (double)execution->request.trip,
        .copies = free_order && !(loop->flags & REDCC_ORDER_NEEDED) && !execution->no_copies &&
                  redcc_copies_allowed(execution),
        .copied = (double)redcc_copy_bytes(&execution->partition, execution->touched),
        .by_graph = execution->by_graph,
        .budget = redcc_budget()};
}

enum rule redcc_find_way(struct execution *execution, const struct estimate *estimate) {
    struct findings findings = begin_findings(execution);
    findings.share = estimate->share;
    findings.runs = estimate->changes * (double)findings.trip;
    findings.reusable = (execution->request.loop->flags & REDCC_VERIFIABLE) != 0;
    return redcc_choose_way(&execution->state->chooser, &findings);
}

static enum rule find_way_swept(struct execution *execution) {
    struct findings findings = begin_findings(execution);
    findings.swept = true;
    findings.share = redcc_largest_share(execution);
    findings.runs = count_runs(execution);
    findings.reusable = redcc_plan_reusable(&execution->request, execution->sources);
    return redcc_choose_way(&execution->state->chooser, &findings);
}

const struct method *redcc_find_method(struct execution *execution) {
    switch (find_way_swept(execution)) {
    case RULE_EVEN:
    case RULE_INDEX:
        return execution->partition.spares ? &redcc_method_spare_localwrite
                                           : &redcc_method_localwrite;
    case RULE_GRAPH:
        return &redcc_method_graph_localwrite;
    case RULE_CHEAP_COPIES:
    case RULE_COPIES:
        return &redcc_method_expansion;
    default:
        return NULL;
    }
}
