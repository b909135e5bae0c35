/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Adds an execution to the report, and informs method `auto` of its result. */
#include "loop.h"

#include <assert.h>

#include "base/clock.h"
#include "base/trace.h"
#include "plan/rounding.h"

/* Records the mode of the last call; thread-safe. */
static void note_mode(struct statistics *statistics, enum mode mode) {
    assert(mode < MODE_COUNT);
    atomic_store_explicit(&statistics->last.mode, (int)mode, memory_order_relaxed);
}

void redcc_count_fallback(struct loop_state *state, enum reason reason) {
    assert(reason < REASON_COUNT);
    redcc_trace(TRACE_CHOICE, state->execution.call.request.loop, "the original loop%s%s",
                reason == REASON_NONE ? "" : ": ", redcc_reason_text(reason));
    note_mode(&state->reported.statistics, MODE_SEQUENTIAL);
    if (reason != REASON_NONE)
        atomic_fetch_add_explicit(&state->reported.statistics.fallback[reason], 1,
                                  memory_order_relaxed);
}

void redcc_note_sequential(struct statistics *statistics, redcc_int iterations, double seconds) {
    assert(iterations >= 0);
    note_mode(statistics, MODE_TIMED);
    statistics->sequential.calls++;
    statistics->sequential.iterations += iterations;
    statistics->sequential.seconds += seconds;
}

void redcc_note_rule(struct statistics *statistics, enum rule rule) {
    assert(rule < RULE_COUNT);
    atomic_store_explicit(&statistics->rule, (int)rule, memory_order_relaxed);
}

void redcc_note_serial(struct statistics *statistics) {
    statistics->method = &redcc_method_serial;
    statistics->threads = 1;
}

static void count_overlap(struct execution *execution) {
    const redcc_loop *loop = execution->call.request.loop;
    const struct overlap overlap = execution->inspection.overlap;
    const char *source = loop->sources[overlap.source].name;
    const char *array = overlap.array < loop->array_count
                            ? loop->arrays[overlap.array].name
                            : loop->sources[overlap.array - loop->array_count].name;
    redcc_trace(TRACE_CHOICE, loop, "the original loop: '%s' overlaps '%s'", source, array);
    redcc_report_overlap(&execution->state->reported.statistics, source, array);
}

static enum result result_of(const struct execution *execution) {
    switch (execution->reason) {
    case REASON_CHANGED:
        return RESULT_CHANGED;
    case REASON_DEADLINE:
        return RESULT_STOPPED;
    case REASON_UNATTRACTIVE:
    case REASON_SAVING: /* one thread has taken a sample */
        return RESULT_UNATTRACTIVE;
    default:
        return RESULT_REFUSED;
    }
}

/* The strategy that the reason concerns; WAY_SEQUENTIAL: it concerns all strategies. */
static enum way way_concerned(const struct execution *execution) {
    if (execution->call.in_bins)
        return WAY_BINS;
    switch (execution->reason) {
    case REASON_NO_MEMORY:
    case REASON_NO_COPIES:
    case REASON_MIXED:
    case REASON_UNATTRACTIVE:
    case REASON_DEADLINE:
    case REASON_CHANGED:
        return execution->advice.way;
    default:
        return WAY_SEQUENTIAL;
    }
}

/* The fraction of the plan construction that was completed at the deadline. */
static double part_done(const struct execution *execution) {
    const struct inspection *inspection = &execution->inspection;
    if (execution->reason != REASON_DEADLINE)
        return 0;
    if (inspection->route == ROUTE_SERIAL)
        return redcc_dry_run_done(inspection);
    const double swept = redcc_sweep_done(inspection);
    return execution->advice.way == WAY_GRAPH ? swept / 3 : swept;
}

static void trace_outcome(const struct loop_state *state, const redcc_loop *loop,
                          const struct outcome *outcome) {
    static const char *const results[] = {
        [RESULT_SEQUENTIAL] = "sequential", [RESULT_PARALLEL] = "in parallel",
        [RESULT_UNATTRACTIVE] = "a look",   [RESULT_STOPPED] = "an inspection stopped",
        [RESULT_CHANGED] = "a plan lost",   [RESULT_REFUSED] = "a plan refused",
        [RESULT_LEFT] = "bins left"};
    redcc_trace(TRACE_CHOICE, loop, "%s: %.3g s, set-up %.3g s; may lose %.3g s",
                results[outcome->result], outcome->seconds, outcome->set_up,
                redcc_credit(&state->chooser.state));
}

void redcc_inform_auto(struct loop_state *state, const redcc_loop *loop,
                       const struct outcome *outcome, enum reason reason) {
    redcc_tell(&state->chooser, outcome, reason);
    redcc_note_rule(&state->reported.statistics, redcc_advice_rule(&state->chooser, outcome->trip));
    trace_outcome(state, loop, outcome);
}

static void account_refused(struct execution *execution, double now) {
    struct loop_state *state = execution->state;
    struct statistics *statistics = &state->reported.statistics;
    const redcc_int trip = execution->call.request.asked;
    if (execution->reason == REASON_OVERLAP) {
        count_overlap(execution);
        note_mode(statistics, MODE_SEQUENTIAL);
    } else
        redcc_count_fallback(state, execution->reason);
    redcc_note_serial(statistics);
    statistics->inspect_seconds += now - execution->call.entered;
    if (execution->reason == REASON_NO_MEMORY) {
        redcc_cache_drop_all(&state->cache);
        redcc_bins_drop(&state->binning);
    }
    if (execution->call.method)
        return;
    const struct outcome outcome = {.result = result_of(execution),
                                    .way = way_concerned(execution),
                                    .trip = trip,
                                    .seconds = now - execution->call.entered,
                                    .done = part_done(execution)};
    redcc_inform_auto(state, execution->call.request.loop, &outcome, execution->reason);
}

static const char *origin_of_plan(const struct execution *execution) {
    if (execution->inspected)
        return "built";
    return redcc_reuse_skipped_sources(&execution->reuse) > 0 ? "used again, subscripts watched"
                                                              : "used again";
}

static void trace_execution(const struct execution *execution, double now) {
    const struct run *run = &execution->run;
    const struct plan *plan = run->plan;
    const redcc_loop *loop = execution->call.request.loop;
    const double trip = (double)(plan->trip > 0 ? plan->trip : 1);
    if (redcc_traces(TRACE_PLAN))
        redcc_trace(TRACE_PLAN, loop,
                    "%s: %s, %d threads, %u owners, %.4f iterations executed for one, %u stages, "
                    "%zu bytes; %.3g s",
                    origin_of_plan(execution), plan->method->name, plan->threads, plan->owners,
                    (double)plan->executed / trip, redcc_plan_stages(plan), redcc_plan_bytes(plan),
                    run->ready - execution->call.entered);
    redcc_trace(TRACE_EXECUTION, loop, "%lld iterations by %d threads; %.3g s", plan->trip,
                execution->call.threads, now - run->ready);
}

static void count_nodes(const struct execution *execution, struct statistics *statistics) {
    unsigned long long nodes = 0;
    for (int t = 0; t < execution->call.threads; t++) {
        const struct thread_state *thread = execution->state->thread[t];
        nodes |= thread->node >= 0 ? 1ull << (thread->node & 63) : 0;
        statistics->placement.moves += thread->moved;
    }
    statistics->placement.nodes = __builtin_popcountll(nodes);
}

static void inform_auto(struct execution *execution, double now) {
    struct loop_state *state = execution->state;
    const struct plan *plan = execution->run.plan;
    /* auto keeps no plans that select, but fences */
    const bool built =
        execution->inspected && (!plan->method->selects || execution->run.fences.are_new);
    const double entered = execution->call.entered, ready = execution->run.ready;
    const struct outcome outcome = {.result = RESULT_PARALLEL,
                                    .way = redcc_way_of(plan->method),
                                    .trip = execution->call.request.asked,
                                    .seconds = now - (built ? ready : entered),
                                    .set_up = built ? ready - entered : 0};
    redcc_inform_auto(state, execution->call.request.loop, &outcome, REASON_NONE);
}

void redcc_count_lost(struct execution *execution) {
    struct reuse *reuse = &execution->reuse;
    assert(reuse->changed_source < 0 ||
           (uint32_t)reuse->changed_source < execution->call.request.loop->source_count);
    if (reuse->changed_source >= 0)
        redcc_report_lost(&execution->state->reported.statistics,
                          execution->call.request.loop->sources[reuse->changed_source].name);
    reuse->changed_source = -1;
}

/* Reports measurements of the team, whatever the loop's result. */
static void report_team(struct execution *execution) {
    const struct call *call = &execution->call;
    const double woken = execution->woken;
    if (!call->method && !execution->advice.alone)
        redcc_tell_team(&execution->state->chooser, call->asked, call->threads,
                        woken > 0 ? woken - call->entered : 0, call->started);
}

static void note_variant(const struct execution *execution, struct statistics *statistics) {
    double seconds[VARIANT_PARTS] = {0}, iterations[VARIANT_PARTS] = {0};
    for (int t = 0; t < execution->call.threads; t++)
        redcc_parts_add(&execution->state->thread[t]->runner.parts, seconds, iterations);
    redcc_run_note_variant(&execution->run, &execution->state->variants, seconds, iterations);
    statistics->last.lanes = execution->run.variant.lanes;
    statistics->last.lanes_reason = execution->run.variant.why;
}

/* Notes that an iteration left a fence, so that the last `rest` iterations were executed in order.
 */
static void note_stray(struct execution *execution, redcc_int rest) {
    const redcc_loop *loop = execution->call.request.loop;
    redcc_fences_fail(&execution->run.fences);
    redcc_trace(TRACE_CHOICE, loop, "the last %lld iterations in order: %s", rest,
                redcc_reason_text(REASON_STRAYED));
    atomic_fetch_add_explicit(&execution->state->reported.statistics.fallback[REASON_STRAYED], 1,
                              memory_order_relaxed);
}

/* For methods whose threads find their iterations during execution: sets the numbers of executed
 * iterations, which are known only afterwards. */
static void count_selected(struct execution *execution) {
    struct plan *plan = execution->run.plan;
    if (!plan->method->selects)
        return;
    const struct runner *runner = &execution->state->thread[0]->runner;
    const redcc_int rest = plan->trip - runner->selection.end;
    if (rest > 0)
        note_stray(execution, rest);
    plan->executed = rest;
    plan->length = 0;
    for (int t = 0; t < execution->call.threads; t++) {
        const redcc_int executed = execution->state->thread[t]->runner.selection.executed;
        plan->executed += executed;
        plan->length = executed > plan->length ? executed : plan->length;
    }
    plan->length += rest;
}

static void account_execution(struct execution *execution, double now) {
    count_selected(execution);
    struct statistics *statistics = &execution->state->reported.statistics;
    const struct run *run = &execution->run;
    const struct plan *plan = run->plan;
    const bool built = execution->inspected;
    const size_t bytes = built ? redcc_plan_bytes(plan) : 0;
    statistics->method = plan->method;
    statistics->parameter = plan->parameter;
    statistics->threads = execution->call.threads;
    note_mode(statistics, built ? MODE_BUILT : MODE_REUSED);
    statistics->plans_built += built;
    statistics->plans_reused += !built;
    statistics->watched += !built && redcc_reuse_skipped_sources(&execution->reuse) > 0;
    statistics->inspect_seconds += run->ready - execution->call.entered;
    statistics->execute_seconds += now - run->ready;
    statistics->extra.bytes = bytes > statistics->extra.bytes ? bytes : statistics->extra.bytes;
    statistics->extra.executed += plan->executed;
    statistics->in_loops += plan->trip;
    statistics->last.stages = redcc_plan_stages(plan);
    statistics->last.trip = plan->trip;
    statistics->last.length = plan->length;
    statistics->last.compensated = redcc_rounding_bytes(plan) > 0;
    count_nodes(execution, statistics);
    note_variant(execution, statistics);
    trace_execution(execution, now);
    if (!execution->call.method)
        inform_auto(execution, now);
    if (redcc_in_sections(&execution->call)) {
        execution->run.plan->copies.is_neutral = true;
        redcc_sections_timed(&execution->state->sections, plan->trip, execution->call.threads,
                             now - execution->call.entered);
    }
}

static void inform_auto_of_bins(struct execution *execution, double now) {
    struct loop_state *state = execution->state;
    const struct request *request = &execution->call.request;
    const struct outcome outcome = {
        .result = execution->reason == REASON_SERIAL_FASTER ? RESULT_LEFT : RESULT_PARALLEL,
        .way = WAY_BINS,
        .trip = request->trip,
        .seconds = now - execution->call.entered,
        .usual = redcc_bins_usual(&state->binning)};
    redcc_inform_auto(state, request->loop, &outcome, REASON_NONE);
}

/* Counts an execution in bins. It counts even if the rest of the loop was executed sequentially
 * after some rounds. */
static void account_binned(struct execution *execution, double now) {
    struct loop_state *state = execution->state;
    struct statistics *statistics = &state->reported.statistics;
    const struct binning *binning = &state->binning;
    const struct call *call = &execution->call;
    const redcc_int trip = call->request.trip, rest = trip - binning->round.begin;
    if (execution->reason == REASON_OVERLAP)
        count_overlap(execution);
    else if (execution->reason != REASON_NONE)
        redcc_count_fallback(state, execution->reason);
    const bool in_shares = redcc_in_shares(call);
    statistics->method = in_shares ? &redcc_method_sections : &redcc_method_binning;
    statistics->parameter = in_shares ? binning->copies.count : call->parameter;
    statistics->threads = call->threads;
    statistics->inspect_seconds += execution->run.ready - call->entered;
    statistics->execute_seconds += now - execution->run.ready;
    note_mode(statistics, MODE_BINNED);
    if (binning->bytes > statistics->extra.bytes)
        statistics->extra.bytes = binning->bytes;
    statistics->extra.executed += trip;
    statistics->in_loops += trip;
    statistics->last.stages = binning->rounds;
    statistics->last.trip = trip;
    statistics->last.length = rest + (trip - rest) / call->threads;
    statistics->last.compensated = false;
    count_nodes(execution, statistics);
    redcc_trace(TRACE_EXECUTION, call->request.loop,
                "%lld iterations by %d threads, %ld rounds of %s, %zu bytes; %.3g s", trip,
                call->threads, binning->rounds,
                binning->copies.count ? "private copies" : "records", binning->bytes,
                now - execution->run.ready);
    if (in_shares)
        redcc_sections_timed(&state->sections, trip, call->threads, now - call->entered);
    if (!call->method)
        inform_auto_of_bins(execution, now);
}

bool redcc_account(struct execution *execution) {
    struct run *run = &execution->run;
    const double now = run->executed > 0 ? run->executed : redcc_seconds();
    report_team(execution);
    redcc_count_lost(execution);
    if (run->plan)
        account_execution(execution, now);
    else if (execution->binned)
        account_binned(execution, now);
    else
        account_refused(execution, now);
    return run->plan != NULL || execution->binned;
}

void redcc_note_misnamed(redcc_loop *loop, long count) {
    assert(count >= 0);
    struct loop_state *state = redcc_state_of(loop);
    if (state)
        atomic_fetch_add(&state->reported.statistics.validated.misnamed, count);
}
