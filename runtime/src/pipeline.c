/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The stages of the pipeline, which pipeline.h draws. */
#include "pipeline.h"

#include "base/aliases.h"
#include "base/clock.h"
#include "loop.h"
#include "plan/check.h"

#include <assert.h>

static enum stage refuse(struct execution *execution, enum reason reason) {
    assert(reason != REASON_NONE);
    execution->reason = reason;
    /* after a deadline, the route is needed to tell how far it got */
    if (reason != REASON_DEADLINE)
        execution->inspection.route = ROUTE_SERIAL;
    return STAGE_OVER;
}

/* ---- verify ---------------------------------------------------------------------------------- */

/* Searches for a plan. If a method is named, any of its kept plans may be used; auto uses only
 * plans of the strategy that it has chosen. Of the plans without schedules, auto keeps only those
 * for tiles, because they do not depend on subscripts. */
void redcc_find_plan(struct execution *execution) {
    struct reuse *reuse = &execution->reuse;
    reuse->found = NULL;
    if (redcc_in_sections(&execution->call)) {
        execution->run.plan = redcc_sections_plan(&execution->state->sections, &execution->call);
        return;
    }
    const bool is_kept =
        !redcc_keeps_owners(execution) || execution->call.request.loop->flags & REDCC_TILES;
    if (!execution->call.in_bins && is_kept &&
        (execution->call.method || execution->advice.action == ACTION_REUSE))
        redcc_reuse_find(reuse, execution->call.threads,
                         execution->call.method ? WAY_SEQUENTIAL : execution->advice.way);
}

static enum progress come_together(struct thread_state *thread, redcc_worker *worker) {
    (void)thread;
    (void)worker;
    return PROGRESS_MEET;
}

static enum stage recount(struct execution *execution) {
    redcc_find_plan(execution);
    return STAGE_VERIFY;
}

static enum progress verify(struct thread_state *thread, redcc_worker *worker) {
    (void)worker;
    struct execution *execution = thread->execution;
    struct reuse *reuse = &execution->reuse;
    if (redcc_in_sections(&execution->call))
        return execution->run.plan ? PROGRESS_PASS : PROGRESS_MEET;
    if (!reuse->found || !redcc_reuse_verify(reuse, &thread->hasher))
        return PROGRESS_MEET;
    thread->runner.plan = reuse->found->plan;
    if (thread->thread == 0)
        execution->run.plan = reuse->found->plan;
    return PROGRESS_PASS;
}

static enum stage begin_plan(struct execution *execution, const struct method *method);

/* Can fences replace the inspection? The owners are kept, and nothing needs exact extents. */
static bool has_fences(struct execution *execution) {
    const struct call *call = &execution->call;
    const struct request *request = &call->request;
    return redcc_keeps_owners(execution) && redcc_may_be_fenced(request->loop) &&
           execution->inspection.partition.share > 0 && !call->compensated &&
           !execution->run.validated && !redcc_may_be_tiled(&execution->inspection) &&
           !redcc_may_have_aliases() &&
           redcc_fences_set(&execution->run.fences, request->loop, request->bases, request->known);
}

static enum stage begin_inspection(struct execution *execution) {
    const bool named = execution->call.method != NULL;
    const bool is_dry = execution->call.request.loop->flags & REDCC_DRY_RUN;
    redcc_reuse_drop_found(&execution->reuse);
    if (redcc_in_sections(&execution->call))
        return refuse(execution, REASON_NO_MEMORY);
    const bool is_direct = redcc_goes_directly(&execution->advice);
    if (!named && !is_direct && !execution->call.in_bins &&
        execution->advice.action == ACTION_REUSE) /* auto cannot afford a new plan yet */
        return refuse(execution, REASON_CHANGED);
    if (!redcc_known_are_disjoint_from_scalars(execution->call.request.loop,
                                               execution->call.request.known,
                                               &execution->inspection.overlap))
        return refuse(execution, REASON_OVERLAP); /* must be checked before the slice reads */
    if (is_dry && redcc_may_have_aliases())
        return refuse(execution, REASON_TWO_ADDRESSES);
    execution->inspected = true;
    /* The sample has no deadline; auto sets one after it. */
    execution->inspection.pace = (struct pace){
        .usual = execution->advice.usual,
        .began = redcc_seconds(),
        .deadline =
            is_dry && !named && !is_direct ? redcc_seconds() + execution->advice.deadline : 0};
    if (!redcc_inspection_begin(&execution->inspection,
                                named ? execution->call.method->selects : is_direct))
        return refuse(execution, REASON_NO_MEMORY);
    if (has_fences(execution)) {
        execution->inspection.route = ROUTE_DIRECT;
        return begin_plan(execution, &redcc_method_localwrite_direct);
    }
    return is_dry ? STAGE_DRY_RUN : STAGE_SAMPLE;
}

/* ---- dry run --------------------------------------------------------------------------------- */

static enum progress dry_run(struct thread_state *thread, redcc_worker *worker) {
    const struct inspection *inspection = &thread->execution->inspection;
    if (!thread->telling &&
        (thread->thread > 0 || !redcc_dry_run_start(inspection, &thread->inspector)))
        return PROGRESS_MEET;
    return redcc_dry_run_hand_out(inspection, &thread->inspector, worker) ? PROGRESS_TELL
                                                                          : PROGRESS_MEET;
}

static enum stage after_dry_run(struct execution *execution) {
    const enum reason reason =
        redcc_dry_run_finish(&execution->inspection, &execution->call.request.trip);
    execution->inspection.pace.deadline = 0;
    if (reason == REASON_DEADLINE) /* the deadline passed before a strategy was chosen */
        execution->inspection.route = ROUTE_SERIAL;
    return reason == REASON_NONE ? STAGE_SAMPLE : refuse(execution, reason);
}

/* ---- sample ---------------------------------------------------------------------------------- */

static enum progress sample(struct thread_state *thread, redcc_worker *worker) {
    const struct inspection *inspection = &thread->execution->inspection;
    if (thread->telling)
        redcc_flush(worker);
    else
        redcc_sample_start(inspection, &thread->inspector);
    return redcc_sample_hand_out(inspection, &thread->inspector, worker) ? PROGRESS_TELL
                                                                         : PROGRESS_MEET;
}

/* Called if the access graph cannot be used. Falls back to owners by address, or to what auto
 * chooses instead; a named method in levels is refused. */
static enum stage fall_back(struct execution *execution) {
    const struct method *named = execution->call.method;
    if (named && named->in_levels)
        return refuse(execution, REASON_LEVELS);
    redcc_divide_end(&execution->inspection.divide);
    execution->inspection.no_graph = true;
    execution->inspection.route = ROUTE_OWNERS;
    redcc_tell_no_graph(&execution->advice);
    return STAGE_SWEEP;
}

static enum stage begin_log(struct execution *execution, bool is_exact) {
    switch (redcc_log_begin(&execution->inspection, is_exact)) {
    case DIVIDE_DONE:
        return STAGE_SWEEP;
    case DIVIDE_NO_MEMORY:
        return refuse(execution, REASON_NO_MEMORY);
    default:
        return fall_back(execution);
    }
}

/* Prepares a sweep that only finds address ranges, for a loop that will be binned. */
static enum stage sweep_for_extents(struct execution *execution) {
    struct inspection *inspection = &execution->inspection;
    inspection->route = ROUTE_DIRECT;
    redcc_advise_check(&execution->advice, inspection);
    const bool possible = redcc_cut(inspection, NULL) &&
                          (inspection->whole.cut ||
                           redcc_partition_see_whole(&inspection->whole, &inspection->partition));
    return possible ? STAGE_SWEEP : refuse(execution, REASON_NO_MEMORY);
}

/* Cuts the arrays of each group into the ranges of the owners, and continues with a sweep. If auto
 * decides by the sample that the inspection does not pay, ends it. */
static enum stage cut(struct execution *execution) {
    struct inspection *inspection = &execution->inspection;
    const struct call *call = &execution->call;
    struct estimate estimate = {0};
    if (call->in_bins)
        return sweep_for_extents(execution);
    const bool decides =
        redcc_wants_estimate(inspection) && !redcc_goes_directly(&execution->advice);
    if (!redcc_cut(inspection, decides ? &estimate : NULL))
        return refuse(execution, REASON_NO_MEMORY);
    if (call->started > 0 && execution->woken > 0)
        execution->advice.awaited = execution->woken - call->entered;
    inspection->route =
        redcc_advise_sampled(&execution->state->chooser, &execution->advice, inspection, &estimate);
    if (inspection->route == ROUTE_SERIAL)
        return refuse(execution, execution->advice.alone ? REASON_SAVING : REASON_UNATTRACTIVE);
    if (inspection->route == ROUTE_DIRECT && !inspection->whole.cut &&
        !redcc_partition_see_whole(&inspection->whole, &inspection->partition))
        return refuse(execution, REASON_NO_MEMORY);
    return redcc_is_logged(inspection) ? begin_log(execution, false) : STAGE_SWEEP;
}

static enum stage after_sample(struct execution *execution) {
    const enum reason reason = redcc_sample_finish(&execution->inspection);
    return reason == REASON_NONE ? cut(execution) : refuse(execution, reason);
}

/* ---- sweep ----------------------------------------------------------------------------------- */

static void begin_sweep(struct thread_state *thread) {
    const struct inspection *inspection = &thread->execution->inspection;
    const size_t hashed =
        inspection->call->in_bins
            ? 0
            : redcc_hash_begin(&thread->hasher, &inspection->call->request, inspection->sources);
    redcc_sweep_start(inspection, &thread->inspector, hashed);
}

static enum progress sweep(struct thread_state *thread, redcc_worker *worker) {
    const struct inspection *inspection = &thread->execution->inspection;
    struct inspector *inspector = &thread->inspector;
    if (!thread->telling) {
        begin_sweep(thread);
    } else {
        redcc_flush(worker);
        const double recorded = redcc_sweep_close(inspection, inspector);
        if (!inspection->call->in_bins)
            redcc_hash_some(&thread->hasher, inspection->call->request.loop, recorded);
    }
    if (redcc_sweep_hand_out(inspection, inspector, worker))
        return PROGRESS_TELL;
    if (!inspector->failed && !redcc_is_logged(inspection))
        redcc_sweep_count(&inspector->sweep, inspector->executed);
    return PROGRESS_MEET;
}

/* The last check before a plan is built: returns the reason why this method cannot execute this
 * loop, or REASON_NONE. */
static enum reason objection(const struct inspection *inspection, const struct method *method) {
    if (inspection->partition.mixed && method->keeps != REDCC_ORDER_SERIAL)
        return REASON_MIXED;
    if (method->tiles && !redcc_may_be_tiled(inspection))
        return REASON_NO_TILES;
    if (method->copies != COPY_NONE &&
        !redcc_copies_possible(&inspection->partition, inspection->touched))
        return REASON_NO_COPIES;
    return REASON_NONE;
}

static void summarise(struct inspection *inspection) {
    for (int thread = 0; thread < inspection->call->threads; thread++) {
        const struct inspector *inspector = inspection->inspector[thread];
        const bool divided = inspection->route == ROUTE_GRAPH;
        inspection->summaries[thread] =
            divided ? &inspection->divide.sweep[thread].summary : &inspector->sweep.summary;
        inspection->seen[thread] = inspector->seen;
    }
}

/* Creates an empty plan for the method, which all threads fill. */
static enum stage begin_plan(struct execution *execution, const struct method *method) {
    struct inspection *inspection = &execution->inspection;
    const struct call *call = &execution->call;
    const int parameter = call->method ? call->parameter : method->usual;
    const struct fences *fences = &execution->run.fences;
    const struct range *touched = fences->stand ? fences->allowed : inspection->touched;
    struct plan *plan = redcc_plan_new(method, parameter, call->threads, call->request.trip,
                                       &inspection->partition, touched, call->compensated);
    execution->run.plan = plan;
    summarise(inspection);
    if (method->selects && !(call->request.loop->flags & REDCC_DRY_RUN && fences->stand))
        redcc_survey_begin(&execution->run.survey, call->request.trip, call->threads,
                           &execution->barrier);
    if (plan && inspection->route == ROUTE_DIRECT)
        redcc_plan_take_votes(plan, &inspection->partition, touched);
    if (plan && inspection->route == ROUTE_GRAPH &&
        !redcc_plan_take_map(plan, &inspection->partition, &inspection->divide)) {
        redcc_plan_free(plan);
        execution->run.plan = NULL;
    }
    return execution->run.plan ? STAGE_PLAN : refuse(execution, REASON_NO_MEMORY);
}

/* Called when all iterations are recorded: selects the named method, or the method that auto now
 * chooses, and returns the next stage. */
static enum stage choose_method(struct execution *execution) {
    struct inspection *inspection = &execution->inspection;
    if (inspection->route == ROUTE_COPIES && !redcc_copies_allowed(inspection)) {
        inspection->no_copies = true; /* all iterations touch a larger range than the sample did */
        return cut(execution);
    }
    const bool reusable = redcc_is_reusable(&execution->call.request, inspection->sources);
    const struct method *method =
        redcc_advise_swept(&execution->state->chooser, inspection, reusable);
    if (!method)
        return refuse(execution, REASON_UNATTRACTIVE);
    const enum reason reason = objection(inspection, method);
    if (reason != REASON_NONE)
        return refuse(execution, reason);
    const struct request *request = &execution->call.request;
    if (method->selects && redcc_may_be_fenced(request->loop))
        redcc_fences_learn(&execution->run.fences, request->loop, request->bases, request->known,
                           inspection->touched, inspection->sources);
    return begin_plan(execution, method);
}

static enum stage after_log(struct execution *execution) {
    struct inspection *inspection = &execution->inspection;
    switch (redcc_log_finish(inspection)) {
    case DIVIDE_BEYOND:
        return begin_log(execution, true);
    case DIVIDE_DONE:
        break;
    default:
        return fall_back(execution);
    }
    const bool reusable = redcc_is_reusable(&execution->call.request, inspection->sources);
    execution->method = redcc_advise_logged(&execution->state->chooser, inspection, reusable);
    return execution->method ? STAGE_PARTITION : refuse(execution, REASON_UNATTRACTIVE);
}

static enum stage after_sweep(struct execution *execution) {
    struct inspection *inspection = &execution->inspection;
    const enum reason reason = redcc_sweep_finish(inspection);
    if (reason == REASON_DEADLINE && execution->call.in_bins)
        return refuse(execution, REASON_SERIAL_FASTER);
    if (reason != REASON_NONE)
        return refuse(execution, reason);
    if (execution->call.in_bins) /* for arrays that overlap each other, bins have their own guard */
        return STAGE_BINS;
    switch (redcc_partition_merge(&inspection->partition, inspection->touched)) {
    case MERGE_REFUSED:
        return refuse(execution, REASON_OUT_OF_STEP);
    case MERGE_DONE:
        return cut(execution);
    case MERGE_NOTHING:
        break;
    }
    return redcc_is_logged(inspection) ? after_log(execution) : choose_method(execution);
}

/* ---- partition ------------------------------------------------------------------------------- */

static enum progress partition(struct thread_state *thread, redcc_worker *worker) {
    (void)worker;
    struct inspection *inspection = &thread->execution->inspection;
    if (inspection->route != ROUTE_LEVELS) /* levels are computed by one thread */
        redcc_partition_share(inspection, &thread->inspector, false);
    return PROGRESS_MEET;
}

static enum stage after_partition(struct execution *execution) {
    struct inspection *inspection = &execution->inspection;
    const bool done = inspection->route == ROUTE_LEVELS ? redcc_partition_levels(inspection)
                                                        : inspection->divide.going;
    if (!done)
        return refuse(execution,
                      redcc_inspection_is_late(inspection) ? REASON_DEADLINE : REASON_NO_MEMORY);
    if (inspection->route != ROUTE_LEVELS)
        switch (
            redcc_advise_partitioned(&execution->state->chooser, inspection, &execution->method)) {
        case PARTITIONED_JOIN:
            return STAGE_JOIN;
        case PARTITIONED_LEVELS:
            inspection->route = ROUTE_LEVELS;
            break;
        case PARTITIONED_KEEP:
            break;
        }
    redcc_divide_tidy(&inspection->divide);
    return begin_plan(execution, execution->method);
}

static enum progress join(struct thread_state *thread, redcc_worker *worker) {
    (void)worker;
    redcc_partition_share(&thread->execution->inspection, &thread->inspector, true);
    return PROGRESS_MEET;
}

/* ---- plan ------------------------------------------------------------------------------------ */

static struct evidence evidence_of(const struct inspection *inspection) {
    const struct request *request = &inspection->call->request;
    return (struct evidence){.partition = &inspection->partition,
                             .summary = inspection->summaries,
                             .seen = inspection->seen,
                             .threads = inspection->call->threads,
                             .trip = request->trip,
                             .levels = &inspection->levels,
                             .every_iteration = request->loop->flags & REDCC_EVERY_ITERATION};
}

static enum progress prepare(struct thread_state *thread, redcc_worker *worker) {
    (void)worker;
    const struct inspection *inspection = &thread->execution->inspection;
    const struct request *request = &inspection->call->request;
    const struct evidence evidence = evidence_of(inspection);
    struct inspector *inspector = &thread->inspector;
    struct plan *plan = thread->execution->run.plan;
    inspector->failed =
        !plan->method->prepare(plan, &evidence, thread->thread) ||
        !redcc_copies_take(plan, thread->thread, inspector->seen, inspection->partition.base);
    if (!thread->execution->run.fences.stand && redcc_is_reusable(request, inspection->sources))
        redcc_hash_rest(&thread->hasher, request, inspection->sources);
    return PROGRESS_MEET;
}

static enum stage after_prepare(struct execution *execution) {
    struct plan *plan = execution->run.plan;
    if (redcc_inspection_failed(&execution->inspection)) {
        redcc_plan_free(plan);
        execution->run.plan = NULL;
        return refuse(execution, REASON_NO_MEMORY);
    }
    redcc_plan_finish(plan);
#ifndef NDEBUG
    const struct evidence evidence = evidence_of(&execution->inspection);
    assert(redcc_plan_is_right(plan, &evidence));
#endif
    return STAGE_RUN;
}

/* ---- the table of stages --------------------------------------------------------------------- */

_Static_assert(STAGE_OVER + 1 == STAGES, "the last stage");
static const struct stage_entry {
    enum progress (*each)(struct thread_state *, redcc_worker *);
    enum stage (*then)(struct execution *);
    enum stage passed; /* the next stage if `each` returns PROGRESS_PASS */
} stages[STAGES] = {
    [STAGE_RECOUNT] = {come_together, recount, STAGE_OVER},
    [STAGE_VERIFY] = {verify, begin_inspection, STAGE_RUN},
    [STAGE_DRY_RUN] = {dry_run, after_dry_run, STAGE_OVER},
    [STAGE_SAMPLE] = {sample, after_sample, STAGE_OVER},
    [STAGE_SWEEP] = {sweep, after_sweep, STAGE_OVER},
    [STAGE_PARTITION] = {partition, after_partition, STAGE_OVER},
    [STAGE_JOIN] = {join, after_partition, STAGE_OVER},
    [STAGE_PLAN] = {prepare, after_prepare, STAGE_OVER},
    [STAGE_RUN] = {0},  /* continues in redcc_next (execute/executor.c) */
    [STAGE_BINS] = {0}, /* continues in redcc_bins_next (binned.c) */
    [STAGE_OVER] = {0}, /* continues in redcc_leave */
};

/* Waits at a barrier. The last thread to arrive calls `then`; all threads get the next stage. */
static enum stage meet(struct thread_state *thread, enum stage (*then)(struct execution *)) {
    struct execution *execution = thread->execution;
    if (redcc_barrier_arrive(&execution->barrier, thread->threads)) {
        execution->stage = then(execution);
        assert(execution->stage < STAGES && (execution->stage != STAGE_OVER || execution->reason));
        redcc_barrier_release(&execution->barrier);
    }
    return execution->stage;
}

int redcc_inspect(redcc_worker *worker) {
    struct thread_state *thread = worker->execution;
    if (!thread)
        return 0;
    while (stages[thread->stage].each) {
        const struct stage_entry *stage = &stages[thread->stage];
        const enum progress progress = stage->each(thread, worker);
        assert(progress != PROGRESS_PASS || stage->passed != STAGE_OVER);
        thread->telling = progress == PROGRESS_TELL;
        if (thread->telling)
            return 1;
        thread->stage = progress == PROGRESS_PASS ? stage->passed : meet(thread, stage->then);
    }
    if (thread->stage == STAGE_BINS) {
        worker->last = 0;
        return 0;
    }
    if (thread->stage == STAGE_OVER) {
        thread->runner.step = STEP_END;
        return 0;
    }
    if (!thread->runner.plan)
        thread->runner.plan = thread->execution->run.plan;
    assert(thread->runner.plan);
    return 0;
}

int redcc_is_stale(redcc_worker *worker, redcc_u32 source) {
    struct thread_state *thread = worker->execution;
    assert(thread->stage == STAGE_DRY_RUN);
    return redcc_dry_run_is_stale(&thread->execution->inspection, &thread->inspector, worker,
                                  source);
}

void redcc_flush(redcc_worker *worker) {
    struct thread_state *thread = worker->execution;
    struct inspection *inspection = &thread->execution->inspection;
    struct inspector *inspector = &thread->inspector;
    if (thread->stage == STAGE_DRY_RUN) {
        redcc_dry_run_take(inspection, inspector, worker);
        return;
    }
    if (thread->stage == STAGE_SWEEP)
        redcc_sweep_flush(inspection, inspector, worker);
    else
        redcc_sample_take(inspection, inspector, worker->entry);
    worker->alike = 0;
    worker->inside = 0;
    worker->entry = inspector->entries;
}
