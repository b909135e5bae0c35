/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What an execution adds to the report, and what auto is told of it. */
#include "loop.h"

#include "base/clock.h"
#include "base/trace.h"
#include "plan/lost.h"

#include <assert.h>

static const char *text_of(enum reason reason) {
    static const char *const texts[] = {
#define REDCC_REASON(id, text) text,
        REDCC_REASON_LIST(REDCC_REASON)
#undef REDCC_REASON
    };
    _Static_assert(sizeof texts / sizeof *texts == REASON_COUNT, "a text for each reason");
    assert(reason < REASON_COUNT);
    return texts[reason];
}

void redcc_count_fallback(struct loop_state *state, enum reason reason) {
    redcc_trace(TRACE_CHOICE, state->execution.call.request.loop, "the original loop%s%s",
                reason == REASON_NONE ? "" : ": ", text_of(reason));
    if (reason != REASON_NONE)
        atomic_fetch_add_explicit(&state->reported.statistics.fallback[reason], 1,
                                  memory_order_relaxed);
}

void redcc_note_rule(struct statistics *statistics, enum rule rule) {
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
    const char *array = loop->arrays[overlap.array].name;
    redcc_trace(TRACE_CHOICE, loop, "the original loop: '%s' overlaps '%s'", source, array);
    redcc_report_overlap(&execution->state->reported.statistics, source, array);
}

static void account_refused(struct execution *execution) {
    struct loop_state *state = execution->state;
    struct statistics *statistics = &state->reported.statistics;
    const redcc_int trip = execution->call.request.trip;
    if (execution->reason == REASON_OVERLAP)
        count_overlap(execution);
    else
        redcc_count_fallback(state, execution->reason);
    redcc_note_serial(statistics);
    if (execution->reason == REASON_NO_MEMORY)
        redcc_cache_drop_all(&state->cache);
    if (execution->call.method)
        return;
    redcc_tell_refused(&state->chooser, trip, execution->reason);
    redcc_note_rule(statistics, redcc_advice_rule(&state->chooser, trip));
}

/* One thread has executed all: no plan was worth making. */
static void account_unplanned(struct execution *execution, double now) {
    struct loop_state *state = execution->state;
    struct statistics *statistics = &state->reported.statistics;
    const struct run *run = &execution->run;
    const redcc_int trip = execution->call.request.trip;
    const double inspecting = run->ready - execution->call.entered;
    redcc_count_fallback(state, execution->reason);
    redcc_note_serial(statistics);
    statistics->inspect_seconds += inspecting;
    statistics->execute_seconds += now - run->ready;
    statistics->executed += trip;
    statistics->in_loops += trip;
    statistics->last.trip = statistics->last.length = trip;
    redcc_tell_executed(&state->chooser, &(struct outcome){.trip = trip,
                                                           .mode = MODE_TIMED,
                                                           .seconds = run->alone,
                                                           .spent = inspecting,
                                                           .reason = execution->reason});
    redcc_note_rule(statistics, redcc_advice_rule(&state->chooser, trip));
}

static const char *came_by(const struct execution *execution) {
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
                    came_by(execution), plan->method->name, plan->threads, plan->owners,
                    (double)plan->executed / trip, redcc_plan_stages(plan), redcc_plan_bytes(plan),
                    run->ready - execution->call.entered);
    redcc_trace(TRACE_EXECUTION, loop, "%lld iterations by %d threads; %.3g s", plan->trip,
                run->mode == MODE_TIMED ? 1 : execution->call.threads, now - run->ready);
}

static void count_nodes(const struct execution *execution, struct statistics *statistics) {
    unsigned long long nodes = 0;
    for (int t = 0; t < execution->call.threads; t++) {
        const struct thread_state *thread = execution->state->thread[t];
        nodes |= thread->node >= 0 ? 1ull << (thread->node & 63) : 0;
        statistics->moves += thread->moved;
    }
    statistics->nodes = __builtin_popcountll(nodes);
}

static void tell_auto(struct execution *execution, double now) {
    struct loop_state *state = execution->state;
    const struct run *run = &execution->run;
    const struct plan *plan = run->plan;
    const bool calibrates = redcc_is_calibration(run, plan), timed = run->mode == MODE_TIMED;
    double working = 0;
    for (int t = 0; t < execution->call.threads; t++)
        working += state->thread[t]->runner.ended - state->thread[t]->runner.began;
    const struct outcome outcome = {.trip = plan->trip,
                                    .mode = timed || calibrates ? run->mode : MODE_PARALLEL,
                                    .by_graph = plan->map.owner != NULL || plan->method->in_levels,
                                    .seconds = timed ? run->alone : now - execution->call.entered,
                                    .block = run->block,
                                    .working =
                                        working * (double)plan->trip / (double)plan->executed};
    redcc_tell_executed(&state->chooser, &outcome);
    redcc_note_rule(&state->reported.statistics, redcc_advice_rule(&state->chooser, plan->trip));
}

static void account_execution(struct execution *execution, double now) {
    struct statistics *statistics = &execution->state->reported.statistics;
    const struct run *run = &execution->run;
    const struct plan *plan = run->plan;
    const bool timed = run->mode == MODE_TIMED, built = execution->inspected;
    const size_t bytes = built ? redcc_plan_bytes(plan) : 0;
    statistics->method = timed ? &redcc_method_serial : plan->method;
    statistics->parameter = plan->parameter;
    statistics->threads = timed ? 1 : execution->call.threads;
    statistics->plans_built += built;
    statistics->plans_reused += !built;
    statistics->watched += !built && redcc_reuse_skipped_sources(&execution->reuse) > 0;
    statistics->inspect_seconds += run->ready - execution->call.entered;
    statistics->execute_seconds += now - run->ready;
    statistics->extra_bytes = bytes > statistics->extra_bytes ? bytes : statistics->extra_bytes;
    statistics->executed += timed ? plan->trip : plan->executed;
    statistics->in_loops += plan->trip;
    statistics->last.stages = redcc_plan_stages(plan);
    statistics->last.trip = plan->trip;
    statistics->last.length = timed ? plan->trip : plan->length;
    statistics->last.compensated = !timed && redcc_lost_bytes(plan) > 0;
    count_nodes(execution, statistics);
    trace_execution(execution, now);
    if (!execution->call.method)
        tell_auto(execution, now);
}

bool redcc_account(struct execution *execution) {
    struct run *run = &execution->run;
    const struct request *request = &execution->call.request;
    const bool validated = run->validation.began;
    const double now = validated ? run->executed : redcc_seconds();
    if (validated)
        redcc_validation_end(&run->validation, run->plan, request->loop, request->bases,
                             run->validated);
    if (run->plan)
        account_execution(execution, now);
    else if (execution->inspection.route == ROUTE_TIMED)
        account_unplanned(execution, now);
    else
        account_refused(execution);
    return run->plan || execution->inspection.route == ROUTE_TIMED;
}
