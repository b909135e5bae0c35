/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "choose/advice.h"

#include "base/memory.h"
#include "base/system.h"
#include "choose/budget.h"
#include "plan/copies.h"

static const double uneven = 1.25;       /* of an equal share of the iterations */
static const double shorter = 0.9;       /* than by the owners that were cut */
static const double level_touch = 20e-9; /* seconds that putting in levels takes for a touch */

/* Units of the leading array for each thread. If they are rows of a mesh, stealable blocks cost
 * 1 %. */
enum { LEAST_UNITS_TO_STEAL = 32768 };

/* ---- at entry -------------------------------------------------------------------------------- */

static enum mode mode_of(enum course course, enum pace pace) {
    if (course == COURSE_SERIAL)
        return MODE_SERIAL;
    if (course == COURSE_SOLO)
        return MODE_TIMED;
    return pace == PACE_UNTIMED ? MODE_PARALLEL : pace == PACE_ALONE ? MODE_SOLO : MODE_CONTENDED;
}

static struct advice advice_of(const struct choice *choice) {
    return (struct advice){.mode = mode_of(choice->course, choice->pace),
                           .by_graph = choice->by_graph,
                           .drops_others = choice->graph_settled,
                           .skipped_calls = choice->rested,
                           .reason = choice->reason,
                           .rule = choice->rule};
}

bool redcc_advise_rest(struct chooser *chooser, redcc_int trip, int threads,
                       struct advice *advice) {
    struct choice choice;
    if (!redcc_choose_rests(chooser, trip, threads, &choice))
        return false;
    *advice = advice_of(&choice);
    return true;
}

struct advice redcc_advise_entry(struct chooser *chooser, redcc_int trip, int threads) {
    const struct choice choice = redcc_choose_course(chooser, trip, threads, redcc_budget());
    return advice_of(&choice);
}

/* ---- what is known of the loop ----------------------------------------------------------------
 */

/* The same bits in whatever order the contributions come? */
static bool any_order_is_exact(const redcc_loop *loop) {
    for (uint32_t array = 0; array < loop->array_count; array++)
        if (loop->arrays[array].type > REDCC_UINT64)
            return false;
    return true;
}

static bool memory_allows(size_t limit, size_t bytes) {
    const size_t used = redcc_memory_in_use();
    if (limit)
        return used < limit && bytes < limit - used;
    const uint64_t there = redcc_system_memory();
    return there == 0 || bytes < there / 4;
}

bool redcc_copies_allowed(const struct inspection *inspection) {
    return redcc_copies_possible(&inspection->partition, inspection->touched) &&
           memory_allows(inspection->call->memory_limit,
                         redcc_copy_bytes(&inspection->partition, inspection->touched) *
                             (size_t)inspection->call->threads);
}

/* What is known by the sample and by all iterations alike. */
static struct findings begin_findings(const struct inspection *inspection,
                                      const struct advice *entry) {
    const struct call *call = inspection->call;
    const redcc_loop *loop = call->request.loop;
    const bool free_order = call->order == REDCC_ORDER_ANY || any_order_is_exact(loop);
    return (struct findings){
        .trip = call->request.trip,
        .threads = call->threads,
        .touches = inspection->touches * (double)call->request.trip,
        .copies = free_order && !(loop->flags & REDCC_ORDER_NEEDED) && !inspection->no_copies &&
                  redcc_copies_allowed(inspection),
        .copied = (double)redcc_copy_bytes(&inspection->partition, inspection->touched),
        .by_graph = entry->by_graph,
        .budget = redcc_budget()};
}

/* ---- after the sample -------------------------------------------------------------------------
 */

bool redcc_wants_estimate(const struct inspection *inspection) {
    return !inspection->call->method;
}

static enum rule find_way_sampled(struct chooser *chooser, const struct advice *entry,
                                  const struct inspection *inspection,
                                  const struct estimate *estimate) {
    struct findings findings = begin_findings(inspection, entry);
    findings.share = estimate->share;
    findings.runs = estimate->changes * (double)findings.trip;
    findings.reusable = (inspection->call->request.loop->flags & REDCC_VERIFIABLE) != 0;
    return redcc_choose_way(chooser, &findings);
}

enum route redcc_advise_sampled(struct chooser *chooser, const struct advice *entry,
                                struct inspection *inspection, const struct estimate *estimate,
                                enum reason *reason) {
    const struct call *call = inspection->call;
    struct partition *partition = &inspection->partition;
    if (call->method)
        return ROUTE_OWNERS;
    if (partition->spares > 0 &&
        !redcc_choose_spares(chooser, call->request.trip, call->threads, estimate))
        redcc_partition_join_spares(partition);
    if (entry->mode == MODE_TIMED)
        return ROUTE_OWNERS;
    switch (find_way_sampled(chooser, entry, inspection, estimate)) {
    case RULE_DEFERRED:
        *reason = REASON_REPLICATION;
        return ROUTE_SERIAL;
    case RULE_COSTLY:
        *reason = REASON_COSTLY;
        return ROUTE_SERIAL;
    case RULE_TIMED: /* nobody need know who touches what, only where: for the guard, */
        redcc_partition_in_one(partition);
        return ROUTE_TIMED;
    case RULE_COPIES: /* and how far: for the copies */
    case RULE_CHEAP_COPIES:
        redcc_partition_in_one(partition);
        return ROUTE_COPIES;
    default:
        return ROUTE_OWNERS;
    }
}

/* ---- after the sweep --------------------------------------------------------------------------
 */

const struct method *redcc_advise_swept(struct chooser *chooser, const struct advice *entry,
                                        const struct inspection *inspection, bool reusable) {
    if (inspection->route == ROUTE_TIMED)
        return NULL;
    if (inspection->route == ROUTE_COPIES)
        return &redcc_method_expansion;
    if (inspection->call->method)
        return inspection->call->method;
    struct findings findings = begin_findings(inspection, entry);
    findings.swept = true;
    findings.share = redcc_largest_share(inspection);
    findings.runs = redcc_count_runs(inspection);
    findings.reusable = reusable;
    switch (redcc_choose_way(chooser, &findings)) {
    case RULE_EVEN:
    case RULE_INDEX:
        return inspection->partition.spares ? &redcc_method_spare_localwrite
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

/* ---- after the log and the partition ----------------------------------------------------------
 */

/* The iterations of an owner lie scattered over the loop. */
static bool stealing_is_worth(const struct chooser *chooser, const struct call *call, double share,
                              double spared) {
    const struct estimate found = {.share = share, .spared = spared, .changes = 1};
    return redcc_choose_spares(chooser, call->request.trip, call->threads, &found);
}

/* auto tries stealable blocks where parts are large; what they cost is seen when they are there. */
const struct method *redcc_advise_logged(const struct chooser *chooser,
                                         struct inspection *inspection,
                                         const struct method *method) {
    const struct call *call = inspection->call;
    struct partition *partition = &inspection->partition;
    const uint32_t threads = (uint32_t)call->threads;
    if (call->method || partition->spares || partition->room > REDCC_OWNERS_MOST ||
        inspection->divide.units.leading / threads < LEAST_UNITS_TO_STEAL ||
        !stealing_is_worth(chooser, call, 1.0 / threads, 0))
        return method;
    redcc_partition_add_spares(partition);
    return &redcc_method_spare_graph_localwrite;
}

void redcc_tell_no_graph(struct chooser *chooser, struct advice *entry, redcc_int trip) {
    entry->by_graph = false;
    redcc_choose_no_graph(chooser, trip);
}

/* Are the stealable blocks that were tried not worth what they cost? */
static bool goes_without_stealing(const struct chooser *chooser,
                                  const struct inspection *inspection) {
    const struct call *call = inspection->call;
    if (call->method || !inspection->partition.spares)
        return false;
    const redcc_int with = redcc_executed_in_all(inspection);
    const redcc_int without = redcc_executed_joined(inspection);
    const double trip = (double)call->request.trip;
    return !stealing_is_worth(chooser, call, (double)without / call->threads / trip,
                              (double)(with - without) / trip);
}

/* The owners that were cut leave one thread this share of the iterations. Would it be quicker by
 * levels? If so they are there. */
static bool levels_serve_better(struct inspection *inspection) {
    const struct call *call = inspection->call;
    const double share = redcc_largest_share(inspection), all = (double)call->request.trip;
    if (call->method || share * call->threads <= uneven ||
        redcc_budget() < inspection->touches * all * (redcc_graph_touch + level_touch))
        return false;
    return redcc_partition_levels(inspection) &&
           redcc_levels_length(&inspection->levels, call->threads) < shorter * share * all;
}

enum partitioned redcc_advise_partitioned(struct chooser *chooser, struct inspection *inspection,
                                          const struct method **method) {
    if (goes_without_stealing(chooser, inspection)) {
        redcc_partition_join_spares(&inspection->partition);
        *method = &redcc_method_graph_localwrite;
        return PARTITIONED_JOIN;
    }
    if (!levels_serve_better(inspection))
        return PARTITIONED_KEEP;
    *method = &redcc_method_wavefront;
    redcc_choose_levels(chooser, inspection->call->request.trip);
    return PARTITIONED_LEVELS;
}

/* ---- after the execution ----------------------------------------------------------------------
 */

static void tell_unplanned(struct chooser *chooser, const struct outcome *outcome) {
    redcc_choose_learn(chooser, outcome->trip, COURSE_SOLO, false, outcome->seconds);
    redcc_budget_gain(-outcome->spent);
    if (outcome->reason != REASON_COSTLY)
        redcc_choose_refused(chooser, outcome->trip, outcome->reason);
}

void redcc_tell_executed(struct chooser *chooser, const struct outcome *outcome) {
    if (outcome->reason != REASON_NONE) {
        tell_unplanned(chooser, outcome);
        return;
    }
    if (outcome->mode == MODE_SOLO || outcome->mode == MODE_CONTENDED)
        redcc_choose_learn_pace(chooser, outcome->trip,
                                outcome->mode == MODE_SOLO ? PACE_ALONE : PACE_BESIDE,
                                outcome->block, outcome->working);
    const enum course course = outcome->mode == MODE_TIMED ? COURSE_SOLO : COURSE_PARALLEL;
    redcc_budget_gain(
        redcc_choose_learn(chooser, outcome->trip, course, outcome->by_graph, outcome->seconds));
}

void redcc_tell_refused(struct chooser *chooser, redcc_int trip, enum reason reason) {
    redcc_choose_refused(chooser, trip, reason);
}

enum rule redcc_advice_rule(const struct chooser *chooser, redcc_int trip) {
    return redcc_choose_rule(chooser, trip);
}

int redcc_advise_threads(redcc_int trip, int threads, double seconds, redcc_int iterations) {
    return redcc_worth_threads(trip, threads, seconds, iterations);
}
