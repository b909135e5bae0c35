/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The life of a loop: its state, and enter, join, leave. */
#include "loop.h"

#include "budget.h"
#include "clock.h"
#include "compensate.h"
#include "escapes.h"
#include "forked.h"
#include "memory.h"
#include "node.h"
#include "settings.h"
#include "signals.h"
#include "team.h"
#include "trace.h"

#include <errno.h>
#include <string.h>

static char *copy_text(const char *text) {
    const size_t bytes = strlen(text) + 1;
    char *copy = redcc_memory_take(bytes);
    return copy ? memcpy(copy, text, bytes) : NULL;
}

static void state_free(struct loop_state *state) {
    if (!state)
        return;
    struct execution *execution = &state->execution;
    for (int p = 0; p < REDCC_PLANS; p++)
        redcc_plan_free(state->plans[p]);
    redcc_members_end(state);
    redcc_memory_give(execution->request.bases);
    redcc_memory_give(execution->request.known);
    redcc_memory_give(execution->request.key);
    redcc_memory_give(execution->touched);
    redcc_memory_give(execution->sources);
    redcc_memory_give(state->reported.file);
    redcc_memory_give(state->reported.function);
    redcc_memory_give(state);
}

static struct loop_state *state_new(redcc_loop *loop) {
    struct loop_state *state = redcc_memory_take_zeroed(1, sizeof *state);
    if (!state)
        return NULL;
    struct execution *execution = &state->execution;
    struct request *request = &execution->request;
    execution->state = state;
    request->loop = loop;
    request->bases = redcc_memory_take(loop->array_count * sizeof *request->bases);
    request->known = redcc_memory_take(loop->source_count * sizeof *request->known);
    request->key = redcc_memory_take(loop->key_count * sizeof *request->key);
    execution->touched = redcc_memory_take(loop->array_count * sizeof *execution->touched);
    execution->sources = redcc_memory_take(loop->source_count * sizeof *execution->sources);
    state->reported.file = copy_text(loop->file);
    state->reported.function = copy_text(loop->function);
    state->reported.line = loop->line;
    if (!request->bases || !request->known || !request->key || !execution->touched ||
        !execution->sources || !state->reported.file || !state->reported.function) {
        state_free(state);
        return NULL;
    }
    return state;
}

/* The loop's state; of several threads that come first, one makes it. NULL: no memory. */
static struct loop_state *state_of(redcc_loop *loop) {
    void *state = __atomic_load_n(&loop->state, __ATOMIC_ACQUIRE);
    if (state)
        return state;
    struct loop_state *mine = state_new(loop);
    if (!mine)
        return NULL;
    if (!__atomic_compare_exchange_n(&loop->state, &state, mine, 0, __ATOMIC_ACQ_REL,
                                     __ATOMIC_ACQUIRE)) {
        state_free(mine);
        return state;
    }
    redcc_report_add(&mine->reported);
    return mine;
}

void redcc_loop_forget(redcc_loop *loop) {
    struct loop_state *state = loop->state;
    if (!state)
        return;
    redcc_report_remove(&state->reported);
    state_free(state);
    loop->state = NULL;
}

static const char *text_of(enum reason reason) {
    static const char *const texts[] = {
#define REDCC_REASON(id, text) text,
        REDCC_REASON_LIST(REDCC_REASON)
#undef REDCC_REASON
    };
    return texts[reason];
}

static int serially(struct loop_state *state, enum reason reason) {
    redcc_trace(TRACE_CHOICE, state->execution.request.loop, "the original loop%s%s",
                reason == REASON_NONE ? "" : ": ", text_of(reason));
    if (reason != REASON_NONE)
        atomic_fetch_add_explicit(&state->reported.statistics.fallback[reason], 1,
                                  memory_order_relaxed);
    return 0;
}

void redcc_note_no_memory(redcc_loop *loop) {
    struct loop_state *state = state_of(loop);
    if (!state)
        return;
    atomic_fetch_add_explicit(&state->reported.statistics.calls, 1, memory_order_relaxed);
    serially(state, REASON_NO_MEMORY);
}

static redcc_order order_of(const redcc_loop *loop, const struct settings *settings) {
    return settings->order_given ? settings->order : loop->order;
}

/* An order asked for in so many words, and a method by name that does not keep it. */
static void stop_at_contradiction(const redcc_loop *loop, const struct settings *settings) {
    const redcc_order order = order_of(loop, settings);
    if (!settings->method || settings->method->keeps <= order ||
        !(settings->order_given || loop->flags & REDCC_ORDER_EXPLICIT))
        return;
    redcc_stop("REDCC_METHOD=%s cannot keep order %s, which %s asks for (%s:%d); it gives order %s",
               settings->method->name, redcc_order_name(order),
               settings->order_given ? "REDCC_ORDER" : "the translated loop", loop->file,
               loop->line, redcc_order_name(settings->method->keeps));
}

/* Does the sequential loop not have these bits: another order of the contributions, other sums?
 * Then one thread executes the loop by a plan as well, also within a parallel region and beside
 * other threads: the bits are to be the same everywhere. */
static bool insists(const struct settings *settings) {
    return settings->compensated ||
           (settings->method && settings->method->keeps == REDCC_ORDER_FIXED);
}

/* Compensated sums are added up in the order of the loop, each element by one thread. */
static const struct method *method_of(const struct settings *settings) {
    if (!settings->method && settings->compensated)
        return &redcc_method_localwrite;
    return settings->method;
}

/* What forbids running in parallel without a look at the loop's data. */
static enum reason hindrance(const redcc_loop *loop, const struct settings *settings, int threads,
                             int nested, bool forked) {
    if (settings->method && loop->flags & REDCC_ORDER_NEEDED &&
        settings->method->keeps != REDCC_ORDER_SERIAL)
        return REASON_ORDER_NEEDED;
    if (insists(settings))
        return REASON_NONE;
    if (forked)
        return REASON_FORKED;
    if (nested)
        return REASON_NESTED;
    return threads < 2 ? REASON_ONE_THREAD : REASON_NONE;
}

/* The state for this call: the loop's, held by it, or, where another thread holds that and must
 * not be waited for (it may be waiting for this one), one of its own. NULL, with *reason: none. */
static struct loop_state *hold(struct loop_state *state, redcc_loop *loop, bool insisting,
                               enum reason *reason) {
    int idle = 0;
    if (atomic_compare_exchange_strong_explicit(&state->busy, &idle, 1, memory_order_acquire,
                                                memory_order_relaxed))
        return state;
    *reason = REASON_CONCURRENT;
    if (!insisting)
        return NULL;
    *reason = REASON_NO_MEMORY;
    struct loop_state *other = state_new(loop);
    if (other)
        other->passing = true;
    return other;
}

static void let_go(struct loop_state *state) {
    if (state->passing)
        state_free(state);
    else
        atomic_store_explicit(&state->busy, 0, memory_order_release);
}

static void take_request(struct request *request, redcc_int trip, void *const *bases,
                         const redcc_extent *known, const redcc_word *key) {
    const redcc_loop *loop = request->loop;
    request->trip = trip;
    memcpy(request->bases, bases, loop->array_count * sizeof *bases);
    if (loop->source_count)
        memcpy(request->known, known, loop->source_count * sizeof *known);
    if (loop->key_count)
        memcpy(request->key, key, loop->key_count * sizeof *key);
}

/* Does an execution take long enough for somebody to wait for its end? Also where that is not
 * known. */
static bool is_long(const struct execution *execution) {
    const struct statistics *statistics = &execution->state->reported.statistics;
    return statistics->in_loops == 0 ||
           statistics->execute_seconds * (double)execution->request.trip >
               1e-3 * (double)statistics->in_loops;
}

/* To be called where a region may follow: no handler may leave the execution then, and none begins
 * one of its own. */
static void begin_within(struct execution *execution, int threads) {
    execution->is_within = redcc_within;
    redcc_within = 1;
    execution->holds_signals =
        execution->insists || redcc_may_escape() || redcc_team_grows(threads);
    if (execution->holds_signals)
        execution->signals = redcc_signals_hold();
}

/* The region's threads are there. */
static void relax_within(struct execution *execution) {
    if (!execution->holds_signals)
        return;
    if (!execution->insists && !redcc_may_escape()) {
        execution->holds_signals = false;
        redcc_signals_release(execution->signals);
    } else if (is_long(execution))
        redcc_signals_let_default(execution->signals);
}

/* The loop is let go: nothing of the execution's is touched any more. */
static void end_within(struct loop_state *state) {
    const uint64_t signals = state->execution.signals;
    const bool holds_signals = state->execution.holds_signals;
    const bool was_within = state->execution.is_within;
    let_go(state);
    redcc_within = was_within;
    if (holds_signals)
        redcc_signals_release(signals);
}

static void note_rule(struct statistics *statistics, enum rule rule) {
    atomic_store_explicit(&statistics->rule, (int)rule, memory_order_relaxed);
}

static void note_serial(struct statistics *statistics) {
    statistics->method = &redcc_method_serial;
    statistics->threads = 1;
}

/* The loop is held: begins an execution. False: to be run serially, for *reason. */
static bool begin_execution(struct execution *execution, const redcc_loop *loop,
                            const struct settings *settings, int threads, enum reason *reason) {
    struct loop_state *state = execution->state;
    struct statistics *statistics = &state->reported.statistics;
    execution->method = method_of(settings);
    execution->parameter = settings->parameter;
    execution->order = order_of(loop, settings);
    execution->course = COURSE_PARALLEL;
    execution->pace = PACE_UNTIMED;
    execution->rested = 0;
    execution->by_graph = false;
    if (!execution->method) {
        const struct choice choice =
            redcc_choose_course(&state->chooser, execution->request.trip, threads, redcc_budget());
        execution->course = choice.course;
        execution->rested = choice.rested;
        execution->pace = choice.pace;
        execution->by_graph = choice.by_graph;
        if (choice.graph_settled) /* what there was before need not stay beside it */
            redcc_drop_plain_plans(state);
        *reason = choice.reason;
        note_rule(statistics, choice.rule);
    } else if (execution->method->keeps > execution->order)
        execution->order = execution->method->keeps;
    statistics->order = execution->order;
    if (execution->course == COURSE_SERIAL) {
        note_serial(statistics);
        return false;
    }
    threads = redcc_team_prepare(threads, execution->signals);
    *reason = threads < 1 ? REASON_HANDLER : REASON_NO_THREADS;
    if (threads < (execution->insists ? 1 : 2))
        return false;
    *reason = REASON_NO_MEMORY;
    if (!redcc_members_ensure(state, loop, threads))
        return false;
    execution->asked = execution->threads = threads;
    execution->plan = NULL;
    execution->plan_is_kept = false;
    execution->inspected = false;
    execution->planless = false;
    execution->validation = (struct validation){0};
    execution->reason = REASON_NONE;
    atomic_store_explicit(&execution->last_claimed, 0, memory_order_relaxed);
    atomic_store_explicit(&execution->spares_claimed, 0, memory_order_relaxed);
    return true;
}

/* The bits are the same at any number of threads. */
static int threads_for_compensated(const struct statistics *statistics, redcc_int trip,
                                   int threads) {
    return redcc_worth_threads(trip, threads, statistics->execute_seconds, statistics->in_loops);
}

int redcc_enter(redcc_call *call, redcc_loop *loop, redcc_int trip, void *const *bases,
                const redcc_extent *known, const redcc_word *key, int threads, int nested) {
    const int error_before = errno;
    *call = (redcc_call){.loop = loop, .trip = trip, .threads = 1};
    const bool forked = redcc_is_forked(); /* before anything of the parent's is used */
    const struct settings *settings = redcc_settings();
    stop_at_contradiction(loop, settings);
    struct loop_state *state = state_of(loop);
    if (!state)
        return 0;
    atomic_fetch_add_explicit(&state->reported.statistics.calls, 1, memory_order_relaxed);
    if (trip <= 0 || (settings->method && !settings->method->prepare))
        return 0;
    enum reason reason = hindrance(loop, settings, threads, nested, forked);
    if (reason != REASON_NONE && !settings->method)
        note_rule(&state->reported.statistics, RULE_NOT_PARALLEL);
    if (reason != REASON_NONE)
        return serially(state, reason);
    if (redcc_within && !insists(settings))
        return serially(state, REASON_NESTED);
    struct loop_state *held = hold(state, loop, insists(settings), &reason);
    if (!held)
        return serially(state, reason);
    struct choice choice;
    if (!insists(settings) && !settings->method &&
        redcc_choose_rests(&held->chooser, trip, threads, &choice)) {
        note_rule(&held->reported.statistics, choice.rule);
        note_serial(&held->reported.statistics);
        let_go(held);
        return serially(state, choice.reason);
    }
    struct execution *execution = &held->execution;
    execution->entered = redcc_seconds();
    execution->insists = insists(settings);
    execution->float_control = redcc_float_control();
    execution->request.float_control = execution->float_control;
    execution->error_before = error_before;
    atomic_store_explicit(&execution->error, 0, memory_order_relaxed);
    if (redcc_float_traps(execution->float_control)) {
        let_go(held);
        return serially(state, REASON_TRAPS);
    }
    threads = nested || threads < 1 || forked ? 1 : threads;
    begin_within(execution, threads);
    if (settings->compensated && !settings->method)
        threads = threads_for_compensated(&held->reported.statistics, trip, threads);
    take_request(&execution->request, trip, bases, known, key);
    if (!begin_execution(execution, loop, settings, threads, &reason)) {
        end_within(held);
        return serially(state, reason);
    }
    threads = execution->asked;
    redcc_find_candidate(execution, threads);
    redcc_trace(TRACE_CHOICE, loop, "%lld iterations, %s%s%s, %d threads asked for", trip,
                execution->course == COURSE_SOLO ? "by one thread, timed" : "in parallel",
                execution->method ? " by " : "", execution->method ? execution->method->name : "",
                threads);
    call->threads = threads;
    call->decided = 1;
    call->execution = execution;
    return 1;
}

static void note_node(struct member *member) {
    const int node = redcc_node();
    member->moved = member->node >= 0 && node != member->node;
    member->node = node;
}

void redcc_join(redcc_worker *worker, redcc_call *call, int thread, int threads) {
    struct execution *execution = call->execution;
    *worker = (redcc_worker){.call = call, .thread = thread};
    if (threads > execution->asked) {
        if (thread == 0)
            execution->reason = REASON_TEAM;
        return;
    }
    if (thread == 0) {
        redcc_team_came(threads);
        relax_within(execution);
    }
    struct member *member = execution->state->member[thread];
    worker->execution = member;
    note_node(member);
    member->float_control = redcc_float_control();
    redcc_float_control_take(execution->float_control);
    member->threads = threads;
    member->plan = NULL;
    member->failed = false;
    member->phase = threads == execution->asked ? PHASE_BEGIN : PHASE_RECOUNT;
    const bool too_few = threads == 1 && !execution->insists;
    if (too_few)
        member->phase = PHASE_OVER;
    if (thread == 0 && threads != execution->asked) {
        execution->threads = threads;
        execution->reason = too_few ? REASON_ONE_THREAD : REASON_NONE;
    }
}

static void count_fallback(struct execution *execution) {
    struct loop_state *state = execution->state;
    const redcc_loop *loop = execution->request.loop;
    if (execution->reason == REASON_OVERLAP)
        redcc_trace(TRACE_CHOICE, loop, "the original loop: '%s' overlaps '%s'",
                    loop->sources[execution->clash_source].name,
                    loop->arrays[execution->clash_array].name);
    if (execution->reason == REASON_OVERLAP)
        redcc_report_overlap(&state->reported.statistics,
                             loop->sources[execution->clash_source].name,
                             loop->arrays[execution->clash_array].name);
    else
        serially(state, execution->reason);
    state->reported.statistics.method = &redcc_method_serial;
    state->reported.statistics.threads = 1;
    if (execution->reason == REASON_NO_MEMORY)
        redcc_drop_plans(state);
    if (execution->method)
        return;
    redcc_choose_refused(&state->chooser, execution->request.trip, execution->reason);
    note_rule(&state->reported.statistics,
              redcc_choose_rule(&state->chooser, execution->request.trip));
}

/* One thread has executed all: no plan was worth making. */
static void count_planless(struct execution *execution, double now) {
    struct loop_state *state = execution->state;
    struct statistics *statistics = &state->reported.statistics;
    const redcc_int trip = execution->request.trip;
    const double inspecting = execution->ready - execution->entered;
    const enum reason reason = execution->only_timed ? REASON_COSTLY : REASON_REPLICATION;
    serially(state, reason);
    statistics->method = &redcc_method_serial;
    statistics->threads = 1;
    statistics->inspect_seconds += inspecting;
    statistics->execute_seconds += now - execution->ready;
    statistics->executed += trip;
    statistics->in_loops += trip;
    statistics->trip = statistics->length = trip;
    redcc_choose_learn(&state->chooser, trip, COURSE_SOLO, false, execution->solo_seconds);
    redcc_budget_gain(-inspecting);
    if (!execution->only_timed)
        redcc_choose_refused(&state->chooser, trip, reason);
    note_rule(statistics, redcc_choose_rule(&state->chooser, trip));
}

static const char *came_by(const struct execution *execution) {
    if (!execution->plan_is_kept)
        return "built";
    return redcc_vouched_sources(execution) > 0 ? "used again, subscripts watched" : "used again";
}

static void trace_execution(const struct execution *execution, double now) {
    const struct plan *plan = execution->plan;
    const redcc_loop *loop = execution->request.loop;
    const double trip = (double)(plan->trip > 0 ? plan->trip : 1);
    if (redcc_traces(TRACE_PLAN))
        redcc_trace(TRACE_PLAN, loop,
                    "%s: %s, %d threads, %u owners, %.4f iterations executed for one, %u stages, "
                    "%zu bytes; %.3g s",
                    came_by(execution), plan->method->name, plan->threads, plan->owners,
                    (double)plan->executed / trip, redcc_plan_stages(plan), redcc_plan_bytes(plan),
                    execution->ready - execution->entered);
    redcc_trace(TRACE_EXECUTION, loop, "%lld iterations by %d threads; %.3g s", plan->trip,
                execution->course == COURSE_SOLO ? 1 : execution->threads, now - execution->ready);
}

static void count_nodes(const struct execution *execution, struct statistics *statistics) {
    unsigned long long nodes = 0;
    for (int thread = 0; thread < execution->threads; thread++) {
        const struct member *member = execution->state->member[thread];
        nodes |= member->node >= 0 ? 1ull << (member->node & 63) : 0;
        statistics->moves += member->moved;
    }
    statistics->nodes = __builtin_popcountll(nodes);
}

static void learn_pace(struct execution *execution) {
    const struct plan *plan = execution->plan;
    double working = 0;
    for (int thread = 0; thread < execution->threads; thread++) {
        const struct member *member = execution->state->member[thread];
        working += member->ended - member->began;
    }
    redcc_choose_learn_pace(&execution->state->chooser, plan->trip, execution->pace,
                            execution->part_seconds,
                            working * (double)plan->trip / (double)plan->executed);
}

static void count_execution(struct execution *execution, double now) {
    struct loop_state *state = execution->state;
    struct statistics *statistics = &state->reported.statistics;
    const struct plan *plan = execution->plan;
    const bool solo = execution->course == COURSE_SOLO;
    const size_t bytes = execution->plan_is_kept ? 0 : redcc_plan_bytes(plan);
    statistics->method = solo ? &redcc_method_serial : plan->method;
    statistics->parameter = plan->parameter;
    statistics->threads = solo ? 1 : execution->threads;
    statistics->plans_built += !execution->plan_is_kept;
    statistics->plans_reused += execution->plan_is_kept;
    statistics->watched += execution->plan_is_kept && redcc_vouched_sources(execution) > 0;
    statistics->inspect_seconds += execution->ready - execution->entered;
    statistics->execute_seconds += now - execution->ready;
    statistics->extra_bytes = bytes > statistics->extra_bytes ? bytes : statistics->extra_bytes;
    statistics->executed += solo ? plan->trip : plan->executed;
    statistics->in_loops += plan->trip;
    statistics->stages = redcc_plan_stages(plan);
    statistics->trip = plan->trip;
    statistics->length = solo ? plan->trip : plan->length;
    statistics->compensated = !solo && redcc_lost_bytes(plan) > 0;
    count_nodes(execution, statistics);
    trace_execution(execution, now);
    if (execution->method)
        return;
    if (!solo && redcc_is_paced(execution, plan))
        learn_pace(execution);
    redcc_budget_gain(
        redcc_choose_learn(&state->chooser, plan->trip, execution->course,
                           plan->map != NULL || plan->method->in_levels,
                           solo ? execution->solo_seconds : now - execution->entered));
    note_rule(statistics, redcc_choose_rule(&state->chooser, plan->trip));
}

int redcc_leave(redcc_call *call) {
    if (!call->decided)
        return 0;
    struct execution *execution = call->execution;
    const int done = execution->plan != NULL || execution->planless;
    const bool validated = execution->validation.began;
    const double now = validated ? execution->executed : redcc_seconds();
    if (validated)
        redcc_validation_end(&execution->validation, execution->plan, execution->request.loop,
                             execution->request.bases,
                             &execution->state->reported.statistics.validated);
    if (execution->planless)
        count_planless(execution, now);
    else if (done)
        count_execution(execution, now);
    else
        count_fallback(execution);
    if (execution->inspected)
        redcc_inspection_end(execution);
    if (execution->plan && !execution->plan_is_kept) {
        if (redcc_plan_reusable(&execution->request, execution->sources))
            redcc_keep_plan(execution);
        else
            redcc_plan_free(execution->plan);
    }
    const int error = done ? redcc_error_of(execution) : 0;
    const int error_before = execution->error_before;
    end_within(execution->state);
    errno = error ? error : error_before;
    return done;
}
