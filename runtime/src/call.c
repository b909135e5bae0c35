/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A call of a loop: redcc_enter, redcc_join, redcc_leave. pipeline.h draws the stages between
 * them. */
#include "loop.h"

#include "base/clock.h"
#include "base/crew.h"
#include "base/escapes.h"
#include "base/forked.h"
#include "base/node.h"
#include "base/signals.h"
#include "base/team.h"
#include "base/trace.h"
#include "call_settings.h"
#include "library.h"
#include "plan/share_count.h"
#include "unmade.h"

#include <assert.h>
#include <errno.h>
#include <string.h>

static int serially(struct loop_state *state, enum reason reason) {
    redcc_count_fallback(state, reason);
    return 0;
}

/* Counts a sequential execution whose caller did not call redcc_enter. */
static void note_serial(redcc_loop *loop, enum reason reason) {
    struct loop_state *state = redcc_state_of(loop);
    if (!state)
        return;
    atomic_fetch_add_explicit(&state->reported.statistics.calls, 1, memory_order_relaxed);
    if (!redcc_settings_for(loop)->method)
        redcc_note_rule(&state->reported.statistics, RULE_REFUSED);
    serially(state, reason);
}

void redcc_note_no_memory(redcc_loop *loop) {
    note_serial(loop, REASON_NO_MEMORY);
}

int redcc_is_unlinked(redcc_loop *loop, const redcc_expectation *other) {
    (void)redcc_is_forked(); /* must precede any use of memory allocated by the parent process */
    (void)redcc_settings_for(loop); /* reads REDCC_REPORT */
    struct loop_state *state = redcc_state_of(loop);
    if (state && other)
        redcc_report_unlinked(&state->reported.statistics, other);
    note_serial(loop, REASON_UNLINKED);
    return 0;
}

int redcc_is_alone(redcc_loop *loop) {
    if (redcc_team_is_alone())
        return 1;
    if (redcc_settings_for(loop)->report)
        note_serial(loop, REASON_OTHER_THREADS);
    return 0;
}

redcc_crew *redcc_crew_begin(redcc_loop *loop, int locks) {
    if (!locks || redcc_team_has_met())
        return redcc_crew_new();
    if (redcc_settings_for(loop)->report)
        note_serial(loop, REASON_OTHER_THREADS);
    return NULL;
}

/* May the execution take more than 1 ms, so that a user may be waiting for its end? Also true if
 * its duration is unknown, as before the first execution or with an inspection. */
static bool is_long(const struct execution *execution) {
    const struct statistics *statistics = &execution->state->reported.statistics;
    const bool is_inspected = !execution->call.in_bins && !redcc_in_sections(&execution->call);
    return statistics->in_loops == 0 || (is_inspected && !execution->reuse.found) ||
           statistics->execute_seconds * (double)execution->call.request.trip >
               1e-3 * (double)statistics->in_loops;
}

/* Ends the execution and releases the loop's state, which must not be used afterwards. */
static void end(struct loop_state *state) {
    const struct within within = state->execution.within;
    redcc_loop_release(state);
    redcc_within_end(within);
}

static void take_request(struct request *request, redcc_int trip, void *const *bases,
                         const redcc_extent *known, const redcc_word *key) {
    const redcc_loop *loop = request->loop;
    request->trip = request->asked = trip;
    memcpy(request->bases, bases, loop->array_count * sizeof *bases);
    if (loop->source_count)
        memcpy(request->known, known, loop->source_count * sizeof *known);
    if (loop->key_count)
        memcpy(request->key, key, loop->key_count * sizeof *key);
}

static struct advice advice_for(struct execution *execution, int threads) {
    struct loop_state *state = execution->state;
    execution->reuse.sampled = 0;
    execution->reuse.changed_source = -1;
    if (execution->call.method)
        return (struct advice){.action = ACTION_REUSE,
                               .alone = redcc_is_fixed(&execution->call) && threads == 1};
    const struct advice advice = redcc_advise_entry(&state->chooser, &execution->reuse, threads);
    redcc_note_rule(&state->reported.statistics, advice.rule);
    return advice;
}

/* Begins an execution in a state that was acquired. If the loop must run serially, sets *reason and
 * returns false. */
static bool begin_execution(struct execution *execution, const redcc_loop *loop, int threads,
                            enum reason *reason) {
    struct loop_state *state = execution->state;
    struct call *call = &execution->call;
    execution->advice = advice_for(execution, threads);
    redcc_count_lost(execution);
    *reason = execution->advice.reason;
    state->reported.statistics.order = call->order;
    if (execution->advice.action == ACTION_SEQUENTIAL) {
        redcc_note_serial(&state->reported.statistics);
        return false;
    }
    const bool alone = execution->advice.alone;
    if (!call->method && execution->advice.way == WAY_BINS) {
        call->in_bins = true;
        call->parameter = redcc_method_binning.usual;
    }
    call->planned = threads;
    call->started = alone ? 0 : redcc_team_missing(threads);
    threads = alone ? 1 : redcc_team_prepare(threads, execution->within.signals);
    const bool fixed = redcc_is_fixed(call);
    if (fixed && threads < 1)
        threads = 1;
    *reason = threads < 1 ? REASON_HANDLER : REASON_NO_THREADS;
    if (!alone && threads < (call->one_will_do || call->in_bins ? 1 : 2))
        return false;
    *reason = REASON_NO_MEMORY;
    const bool by_shares = redcc_in_shares(call) && threads < REDCC_MOST_SHARES;
    if (!redcc_threads_ensure(state, loop, by_shares ? REDCC_MOST_SHARES : threads))
        return false; /* each share uses the buffers of one binner (bins/shares.c) */
    call->asked = call->threads = threads;
    if (!alone)
        call->planned = threads;
    execution->inspection.inspector = state->inspector;
    execution->inspection.route = ROUTE_SERIAL;
    execution->inspected = execution->binned = false;
    execution->reuse.hasher = state->hasher;
    execution->reuse.skipped_calls = execution->advice.skipped_calls;
    execution->reuse.earned = execution->advice.earned;
    execution->reason = REASON_NONE;
    execution->woken = 0;
    redcc_run_begin(&execution->run);
    redcc_run_choose_variant(&execution->run, &state->variants);
    const bool is_validated = call->validate && !state->temporary;
    execution->run.validated = is_validated ? &state->reported.statistics.validated : NULL;
    redcc_bins_begin(&state->binning,
                     is_validated   ? 0
                     : call->method ? redcc_bins_tuning.trial
                                    : execution->advice.may_lose,
                     execution->advice.usual,
                     (struct written_witness){is_validated ? redcc_hold_written : NULL, execution});
    return true;
}

/* The number of threads to request. With compensated sums the sequential loop is never timed, so
 * that auto cannot compare; a short loop then gets one thread. */
static int threads_to_ask_for(const struct loop_state *state, const struct call_settings *settings,
                              redcc_int trip, int threads) {
    const struct statistics *statistics = &state->reported.statistics;
    return settings->common->compensated && !settings->method
               ? redcc_advise_threads(trip, threads, statistics->execute_seconds,
                                      statistics->in_loops)
               : threads;
}

/* ---- the original loop, timed ---------------------------------------------------------------- */

enum { MOST_SOURCES = 8 }; /* maximum number of sources whose ranges are stored */
/* The original loop that this thread is about to execute, and its start time. If the loop's body
 * calls another loop, that loop replaces it here, and the outer loop's execution is not timed. */
static _Thread_local struct {
    const redcc_loop *loop; /* NULL: no loop is timed */
    redcc_int trip;
    redcc_extent known[MOST_SOURCES];
    double began;
} original;

int redcc_timed_loops; /* number of loops being timed, in all threads */

static void set_original(const redcc_loop *loop) {
    if (!original.loop != !loop)
        __atomic_fetch_add(&redcc_timed_loops, loop ? 1 : -1, __ATOMIC_RELAXED);
    original.loop = loop;
}

static void time_original(const redcc_loop *loop, redcc_int trip, const redcc_extent *known) {
    set_original(loop);
    original.trip = trip;
    if (loop->source_count && loop->source_count <= MOST_SOURCES)
        memcpy(original.known, known, loop->source_count * sizeof *known);
    original.began = redcc_seconds();
}

/* Can the call proceed without a state? A loop without a state runs unchanged. It gets a state once
 * it has taken long enough, or at once if the settings request more than speed. */
static bool needs_no_state(const struct call_settings *settings, redcc_loop *loop, redcc_int trip,
                           const redcc_extent *known, bool may_gain) {
    const struct settings *common = settings->common;
    if (redcc_made_state_of(loop) || (may_gain && redcc_advise_at_once(loop, trip)) ||
        settings->method || common->compensated || common->validate || common->report ||
        redcc_traced)
        return false;
    if (may_gain && !redcc_within && redcc_unmade_call(&loop->state, trip))
        time_original(loop, trip, known);
    return true;
}

static void note_left_alone(struct statistics *statistics, enum rule rule) {
    redcc_note_rule(statistics, rule);
    redcc_note_serial(statistics);
}

/* Is the call skipped by back-off? If so, sets *reason, releases the loop before any preparations
 * for threads, and times the original loop if the advice says so. */
static bool is_backed_off(struct loop_state *state, redcc_loop *loop, redcc_int trip,
                          const redcc_extent *known, int threads, enum reason *reason) {
    struct advice advice;
    if (!redcc_advise_rest(&state->chooser, trip, threads, &advice))
        return false;
    note_left_alone(&state->reported.statistics, advice.rule);
    redcc_loop_release(state);
    if (advice.timed)
        time_original(loop, trip, known);
    *reason = advice.reason;
    return true;
}

/* Does auto decide to run sequentially before the preparations for threads? If so, sets *reason and
 * ends the execution. */
static bool ends_early(struct loop_state *state, redcc_loop *loop, redcc_int trip,
                       const redcc_extent *known, int threads, enum reason *reason) {
    struct advice advice;
    if (!redcc_advise_saving(&state->chooser, loop, known, trip, threads, &advice))
        return false;
    state->reported.statistics.order = state->execution.call.order;
    note_left_alone(&state->reported.statistics, advice.rule);
    end(state);
    if (advice.timed)
        time_original(loop, trip, known);
    *reason = advice.reason;
    return true;
}

/* If OpenMP would free memory by another allocator than the one that allocated it
 * (redcc_allocator_is_split), ends the execution and returns true. The first call takes 0.06 ms,
 * because it reads the symbols of all objects. */
static bool must_avoid_regions(struct loop_state *state, bool always) {
    if (always || !redcc_allocator_is_split())
        return false;
    if (!state->execution.call.method)
        redcc_note_rule(&state->reported.statistics, RULE_NOT_PARALLEL);
    end(state);
    return true;
}

/* Reports the time of a sequential execution to `auto`. `known` is NULL if the sources' ranges are
 * unavailable. */
static void note_original(redcc_loop *loop, redcc_int trip, const redcc_extent *known,
                          double seconds) {
    const int error = errno;
    struct loop_state *state = NULL;
    redcc_is_forked(); /* the body may have called fork(), and memory is used below */
    const int executions = redcc_unmade_timed(&loop->state, trip, seconds);
    if (executions > 0)
        state = redcc_state_of(loop);
    enum reason reason;
    /* fails if another thread is executing the loop */
    if (state && redcc_loop_acquire(state, loop, false, &reason)) {
        redcc_note_sequential(&state->reported.statistics, trip < REDCC_OPEN_TRIP ? trip : 0,
                              seconds);
        redcc_inform_auto(state, loop,
                          &(struct outcome){.result = RESULT_SEQUENTIAL,
                                            .trip = trip,
                                            .seconds = seconds,
                                            .untimed = executions - 1},
                          REASON_NONE);
        if (known)
            redcc_advise_timed(&state->chooser, loop, known, trip, seconds);
        redcc_loop_release(state);
    }
    errno = error;
}

void redcc_sequential_end(redcc_loop *loop) {
    if (original.loop != loop)
        return;
    const double seconds = redcc_seconds() - original.began;
    set_original(NULL);
    note_original(loop, original.trip, loop->source_count <= MOST_SOURCES ? original.known : NULL,
                  seconds);
}

void redcc_note_done(redcc_loop *loop, redcc_int trip, const redcc_extent *known, double seconds) {
    struct loop_state *state = redcc_settings_for(loop)->report ? redcc_state_of(loop) : NULL;
    if (state) {
        atomic_fetch_add_explicit(&state->reported.statistics.calls, 1, memory_order_relaxed);
        note_left_alone(&state->reported.statistics, RULE_FIRST);
        redcc_count_fallback(state, REASON_SAVING);
    }
    note_original(loop, trip, known, seconds);
}

void redcc_note_begun(redcc_loop *loop, redcc_int rest, redcc_int done, double seconds) {
    const int error = errno;
    struct loop_state *state = redcc_state_of(loop);
    enum reason reason;
    if (state && redcc_loop_acquire(state, loop, false, &reason)) {
        redcc_note_sequential(&state->reported.statistics, done, seconds);
        redcc_advise_begun(&state->chooser, rest, done, seconds);
        redcc_loop_release(state);
    }
    errno = error;
}

/* ---- enter, join, leave ---------------------------------------------------------------------- */

/* Fills the call, so that threads can join the execution. */
static int hand_over(struct execution *execution, redcc_call *call) {
    const int threads = execution->call.asked;
    redcc_find_plan(execution);
    redcc_trace(TRACE_CHOICE, call->loop, "%lld iterations, %s%s%s, %d threads asked for",
                call->trip,
                execution->advice.action == ACTION_INSPECT ? "inspected" : "in parallel",
                execution->call.method ? " by " : "",
                execution->call.method ? execution->call.method->name : "", threads);
    call->threads = threads;
    call->decided = 1;
    call->execution = execution;
    return 1;
}

static int enter(redcc_call *call, redcc_loop *loop, redcc_int trip, void *const *bases,
                 const redcc_extent *known, const redcc_word *key, const redcc_extent *sections,
                 int threads, int nested) {
    const int error_before = errno;
    *call = (redcc_call){.loop = loop, .trip = trip, .threads = 1, .calls = &redcc_library};
    /* must precede any use of memory allocated by the parent process */
    const bool forked = redcc_is_forked();
    set_original(NULL);
    const struct call_settings settings = redcc_settings_of_call(loop, trip, bases, sections);
    const bool may_gain = !nested && (threads > 1 || redcc_one_will_do(loop, &settings));
    if (trip > 0 && needs_no_state(&settings, loop, trip, known, may_gain))
        return 0;
    struct loop_state *state = redcc_state_of(loop);
    if (!state)
        return 0;
    atomic_fetch_add_explicit(&state->reported.statistics.calls, 1, memory_order_relaxed);
    if (trip <= 0)
        return 0;
    enum reason reason = redcc_reason_not_to(loop, &settings, threads, nested, forked);
    if (reason != REASON_NONE && !settings.method)
        redcc_note_rule(&state->reported.statistics, RULE_NOT_PARALLEL);
    if (reason != REASON_NONE)
        return serially(state, reason);
    const bool always = redcc_is_always_planned(settings.method, settings.common->compensated);
    if (redcc_within && !always)
        return serially(state, REASON_NESTED);
    struct loop_state *held = redcc_loop_acquire(state, loop, always, &reason);
    if (!held)
        return serially(state, reason);
    struct execution *execution = &held->execution;
    const bool asks_auto = !always && !settings.method;
    if (asks_auto && is_backed_off(held, loop, trip, known, threads, &reason))
        return serially(state, reason);
    redcc_take_settings(&execution->call, &settings);
    execution->call.entered = redcc_seconds();
    execution->call.float_control = redcc_float_control();
    execution->call.error_before = error_before;
    if (redcc_float_traps(execution->call.float_control)) {
        redcc_loop_release(held);
        return serially(state, REASON_TRAPS);
    }
    threads = nested || threads < 1 || forked ? 1 : threads;
    redcc_within_begin(&execution->within, always, threads);
    if (asks_auto && ends_early(held, loop, trip, known, threads, &reason))
        return serially(state, reason);
    if (must_avoid_regions(held, always))
        return serially(state, REASON_ALLOCATOR);
    threads = redcc_is_fixed(&execution->call)
                  ? redcc_sections_threads(&held->sections, trip, threads)
                  : threads_to_ask_for(held, &settings, trip, threads);
    take_request(&execution->call.request, trip, bases, known, key);
    if (!begin_execution(execution, loop, threads, &reason)) {
        const bool timed = asks_auto && execution->advice.timed;
        end(held);
        if (timed)
            time_original(loop, trip, known);
        return serially(state, reason);
    }
    return hand_over(execution, call);
}

/* Preserves errno: the loop must find the caller's value, in whichever thread it is executed. */
int redcc_enter(redcc_call *call, redcc_loop *loop, redcc_int trip, void *const *bases,
                const redcc_extent *known, const redcc_word *key, int threads, int nested) {
    return redcc_enter_sectioned(call, loop, trip, bases, known, key, NULL, threads, nested);
}

int redcc_enter_sectioned(redcc_call *call, redcc_loop *loop, redcc_int trip, void *const *bases,
                          const redcc_extent *known, const redcc_word *key,
                          const redcc_extent *sections, int threads, int nested) {
    const int error = errno;
    const int parallel = enter(call, loop, trip, bases, known, key, sections, threads, nested);
    errno = error;
    return parallel;
}

static void note_node(struct thread_state *thread) {
    const int node = redcc_node();
    thread->moved = thread->node >= 0 && node != thread->node;
    thread->node = node;
}

void redcc_join(redcc_worker *worker, redcc_call *call, int number, int threads) {
    struct execution *execution = call->execution;
    *worker = (redcc_worker){.call = call, .thread = number};
    if (threads > execution->call.asked) {
        if (number == 0)
            execution->reason = REASON_TEAM;
        return;
    }
    assert(0 <= number && number < threads && threads <= execution->state->thread_count);
    if (number == 0) {
        redcc_team_begun(threads);
        const bool is_dry = execution->call.request.loop->flags & REDCC_DRY_RUN;
        /* with one thread, only a dry run takes so long that a user may be waiting for its end */
        if (!execution->advice.alone || redcc_is_fixed(&execution->call) || is_dry)
            redcc_within_relax(
                &execution->within,
                redcc_is_always_planned(execution->call.method, execution->call.compensated),
                is_long(execution));
    }
    struct thread_state *thread = execution->state->thread[number];
    struct runner *runner = &thread->runner;
    worker->execution = thread;
    if (number > 0 && execution->call.started > 0)
        redcc_signals_take_over();
    if (!execution->advice.alone)
        note_node(thread);
    if (number == threads - 1)
        execution->woken = redcc_seconds();
    runner->float_control = redcc_float_control();
    redcc_float_control_take(execution->call.float_control);
    thread->threads = runner->threads = thread->inspector.threads = thread->hasher.threads =
        threads;
    thread->inspector.failed = false;
    thread->telling = false;
    runner->plan = NULL;
    runner->step = STEP_BEGIN;
    const bool as_asked = threads == execution->call.asked;
    const bool in_bins = execution->call.in_bins;
    const bool may_be_one = execution->call.one_will_do || in_bins || execution->advice.alone;
    const bool too_few = threads == 1 && !may_be_one;
    thread->stage = too_few ? STAGE_OVER : as_asked ? STAGE_VERIFY : STAGE_RECOUNT;
    if (in_bins) {
        const bool checked = execution->call.request.loop->flags & REDCC_BINS_CHECKED;
        thread->stage = checked ? thread->stage : STAGE_BINS;
        redcc_binner_join(thread->binner, threads);
    }
    if (number == 0 && !as_asked) {
        execution->call.threads = execution->call.planned = threads;
        execution->reason = too_few ? REASON_ONE_THREAD : REASON_NONE;
    }
}

int redcc_end(redcc_call *call) {
    struct execution *execution = call->execution;
    const bool done = redcc_account(execution), asks_auto = !execution->call.method;
    const bool in_blocks = execution->run.executed == 0 && /* not repeated for validation */
                           redcc_call_operands(&execution->call) == REDCC_OPERANDS_IN_BLOCKS;
    const redcc_int trip = execution->call.request.asked;
    struct plan *plan = execution->run.plan;
    if (execution->inspected) {
        const bool goes_without = redcc_keeps_owners(execution) && !(plan && plan->method->tiles);
        const bool is_reusable =
            !goes_without && redcc_is_reusable(&execution->call.request, execution->reuse.sources);
        if (done && plan && plan->method->selects && !is_reusable)
            redcc_plan_keep_owners(plan, &execution->inspection.partition);
        redcc_inspection_end(&execution->inspection);
        if (plan && !(is_reusable && redcc_reuse_keep(&execution->reuse, plan)))
            redcc_plan_free(plan);
    }
    const int error = done ? redcc_error_of(&execution->run) : 0;
    const int error_before = execution->call.error_before;
    if (!done && asks_auto)
        time_original(call->loop, trip, execution->call.request.known);
    end(execution->state);
    errno = error ? error : error_before;
    return !done ? 0 : in_blocks ? REDCC_DONE_IN_BLOCKS : REDCC_DONE;
}
