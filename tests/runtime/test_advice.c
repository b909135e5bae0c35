/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* auto on real loops: its decision in each call, and the bits of the original loop each time. Also
 * tests the decision table in docs/methods.md. test_choose_bound.c tests the bounds. */
#include "loop.h"

#include "base/memory.h"
#include "choose/cost_model.h"
#include "choose/waking.h"
#include "problem.h"
#include "unmade.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { TRIP = 200000, ROWS = 50000, THREADS = 2 };

/* The fixture of these tests: a loop that has been called once, sequentially. */
struct called {
    struct problem problem;
    struct described described;
};

/* Each iteration touches one row: in ascending order if `sorted`, else at random. */
static struct problem one_touch_each(bool sorted) {
    struct problem problem = {.name = "one touch each", .trip = TRIP, .touches = TRIP};
    unsigned long random = 88172645463325252u;
    problem.rows = ROWS;
    problem.width = 1;
    problem.doubles = ROWS;
    problem.start = malloc((TRIP + 1) * sizeof *problem.start);
    problem.row = malloc(TRIP * sizeof *problem.row);
    problem.other = malloc(TRIP * sizeof *problem.other);
    problem.value = malloc(TRIP * sizeof *problem.value);
    problem.first = malloc(ROWS * sizeof *problem.first);
    for (int t = 0; t < TRIP; t++) {
        problem.start[t] = t;
        problem.row[t] = sorted ? t / (TRIP / ROWS) : (int)(next_random(&random) % ROWS);
        problem.other[t] = 0;
        problem.value[t] = (double)(next_random(&random) % 100) / 3.0;
    }
    problem.start[TRIP] = TRIP;
    return problem;
}

/* Calls the loop and compares the bits with the expected result. Returns true if the runtime
 * executed the loop. */
static bool call_by(struct called *called, int threads) {
    static double expected[ROWS];
    struct problem *problem = &called->problem;
    long last;
    problem_reset(problem);
    problem_oracle(problem);
    memcpy(expected, problem->first, sizeof expected);
    problem_reset(problem);
    const int done = problem_run(problem, &called->described, threads, &last);
    assert_memory_equal(expected, problem->first, sizeof expected);
    return done;
}

static bool call_right(struct called *called) {
    return call_by(called, THREADS);
}

static struct statistics *statistics_of(struct called *called) {
    return &((struct loop_state *)called->described.loop.state)->reported.statistics;
}

static struct size_state *size_of(struct called *called) {
    struct loop_state *state = called->described.loop.state;
    return &state->chooser.state.size[63 - __builtin_clzll(TRIP)];
}

static struct ledger *ledger_of(struct called *called) {
    return &((struct loop_state *)called->described.loop.state)->chooser.state.ledger;
}

/* Sets the loop's credit to this number of seconds, however long its calls took. */
static void leave_credit(struct called *called, double seconds) {
    struct ledger *ledger = ledger_of(called);
    ledger->overhead = ledger->sequential / 32 - seconds;
}

static int begin(void **state, bool sorted) {
    static struct called called;
    called.problem = one_touch_each(sorted);
    problem_run_tells = false;
    problem_describe(&called.problem, &called.described);
    assert_false(call_right(&called));
    *state = &called;
    return 0;
}

static int begin_sorted(void **state) {
    return begin(state, true);
}

static int begin_shuffled(void **state) {
    return begin(state, false);
}

static int end(void **state) {
    struct called *called = *state;
    redcc_loop_forget(&called->described.loop);
    problem_free(&called->problem);
    assert_int_equal(redcc_memory_live(), 0);
    return 0;
}

static void the_first_call_is_sequential_and_timed(void **state) {
    struct called *called = *state;
    assert_int_equal(statistics_of(called)->rule, RULE_FIRST);
    assert_int_equal(size_of(called)->sequential.count, 1);
    assert_true(size_of(called)->sequential.recent[0] > 0);
}

/* With one thread only lanes can make a loop faster. */
static void one_thread_is_enough_for_lanes(void **state) {
    struct called *called = *state;
    const _Atomic long *one_thread = &statistics_of(called)->fallback[REASON_ONE_THREAD];
    assert_false(call_by(called, 1));
    assert_int_equal(statistics_of(called)->rule, RULE_NOT_PARALLEL);
    assert_int_equal(atomic_load(one_thread), 1);
    called->described.loop.flags |= REDCC_LANES_UNIT * 2;
    leave_credit(called, -1);
    assert_false(call_by(called, 1));
    assert_true(statistics_of(called)->rule != RULE_NOT_PARALLEL);
    assert_int_equal(atomic_load(one_thread), 1);
}

/* No action begins that may cost more than the credit. */
static void nothing_is_begun_without_credit(void **state) {
    struct called *called = *state;
    for (int call = 0; call < 10; call++) {
        leave_credit(called, -1e-3);
        assert_false(call_right(called));
    }
    assert_int_equal(statistics_of(called)->plans_built, 0);
    assert_true(ledger_of(called)->sequential > 0);
}

/* Long iterations: a plan is constructed as soon as their time is known, and it is reused. */
static void a_heavy_loop_is_set_up(void **state) {
    struct called *called = *state;
    problem_tell_slow(&called->described.loop, TRIP, 1e-6);
    assert_true(call_right(called));
    assert_int_equal(statistics_of(called)->plans_built, 1);
    for (int call = 0; call < 5; call++)
        assert_true(call_right(called));
    assert_int_equal(statistics_of(called)->plans_built, 1);
    assert_int_equal(statistics_of(called)->plans_reused, 5);
    assert_int_equal(size_of(called)->phase, PHASE_PARALLEL);
}

/* After a change of subscripts the original loop runs; another plan follows only when the credit
 * allows it. */
static void changed_subscripts_are_not_inspected_at_once(void **state) {
    struct called *called = *state;
    problem_tell_slow(&called->described.loop, TRIP, 1e-6);
    assert_true(call_right(called));
    assert_true(call_right(called));
    called->problem.row[TRIP / 2 + 1] = 0; /* a change that the sample misses */
    leave_credit(called, 1e-9);            /* almost none; below that there would be no overdraft */
    assert_false(call_right(called));
    assert_int_equal(statistics_of(called)->rule, RULE_CHANGED);
    assert_int_equal(atomic_load(&statistics_of(called)->fallback[REASON_CHANGED]), 1);
    assert_int_equal(statistics_of(called)->plans_built, 1);
    for (int t = 0; t < TRIP; t++) /* a change that the sample finds */
        called->problem.row[t] = (called->problem.row[t] + 1) % ROWS;
    /* otherwise an overdraft would be allowed, since the plan repays it at once */
    leave_credit(called, -1e-3);
    assert_false(call_right(called));
    assert_int_equal(statistics_of(called)->plans_built, 1);
}

/* Threads arrived late, so the sample took long for a reason outside the loop. The sample is used
 * nevertheless if an overdraft covers its cost. */
static void a_sample_that_took_long_is_not_lost(void **state) {
    struct called *called = *state;
    problem_tell_slow(&called->described.loop, TRIP, 1e-3);
    assert_true(call_right(called)); /* starts the threads */
    redcc_loop_forget(&called->described.loop);
    problem_describe(&called->problem, &called->described);
    assert_false(call_right(called));
    leave_credit(called, -1e-3);
    assert_false(call_right(called));
    problem_tell_slow(&called->described.loop, TRIP, 1e-3); /* deadlines are several seconds */
    ((struct loop_state *)called->described.loop.state)->chooser.verified = true;
    size_of(called)->look = 1e-12;
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++)
        size_of(called)->arm[way].learned = 0;
    leave_credit(called, 1e-9);
    assert_true(call_right(called));
    assert_int_equal(statistics_of(called)->plans_built, 1);
}

/* If the slice is more expensive than the body, inspections take too long. So do executions in
 * which threads find their iterations by the slice. */
static void an_expensive_slice_is_seen(void **state) {
    struct called *called = *state;
    problem_searches = 1000; /* 0.4 microseconds; the body takes some nanoseconds */
    leave_credit(called, 1);
    for (int call = 0; call < 10 && !size_of(called)->looked; call++)
        call_right(called);
    problem_searches = 0;
    const struct size_state *size = size_of(called);
    assert_true(size->looked);
    assert_true(size->arm[WAY_DIRECT].execution > 0.1e-6);
    assert_true(size->arm[WAY_INDEX].set_up > 0.5 * 0.1e-6 * (double)TRIP);
    assert_false(redcc_is_better(size, WAY_DIRECT, redcc_usual(size)));
}

/* An inspection that reaches its deadline leaves the arrays unchanged, and its cost is learned. */
static void an_inspection_ends_at_its_deadline(void **state) {
    struct called *called = *state;
    problem_tell_slow(&called->described.loop, TRIP, 1e-6);
    struct size_state *size = size_of(called);
    size->looked = true;
    size->arm[WAY_INDEX] =
        (struct arm){.possible = true, .set_up = 1e-9, .learned = 1e-9, .execution = 1e-8};
    /* more than the plans have saved, so that no overdraft is allowed and the credit must pay */
    size->set_ups.invested = 1e-9;
    assert_false(call_right(called));
    assert_int_equal(statistics_of(called)->rule, RULE_STOPPED);
    assert_int_equal(atomic_load(&statistics_of(called)->fallback[REASON_DEADLINE]), 1);
    assert_int_equal(statistics_of(called)->plans_built, 0);
    assert_true(size->arm[WAY_INDEX].learned > 1e-6 || size->look > 1e-6);
    for (int call = 0; call < 10 && statistics_of(called)->plans_built == 0; call++)
        call_right(called); /* each stop doubles the lower bound on the cost */
}

/* Short loops stay sequential, at the cost of a compare and a counter. */
static void short_loops_are_left_alone(void **state) {
    struct called *called = *state;
    for (int i = 0; i < 3; i++)
        size_of(called)->sequential.recent[i] = 1e-12;
    for (int call = 0; call < 10; call++) {
        assert_false(call_right(called));
        assert_int_equal(statistics_of(called)->rule, RULE_SHORT);
    }
    assert_int_equal(size_of(called)->phase, PHASE_SHORT);
    assert_int_equal(atomic_load(&statistics_of(called)->fallback[REASON_LITTLE_WORK]), 10);
}

/* A loop in back-off stays sequential, but each call is timed. Its subscripts are sampled in the
 * last call of the back-off. */
static void resting_loops_are_left_alone(void **state) {
    enum { REST = 16 };
    struct called *called = *state;
    struct size_state *size = size_of(called);
    uint64_t *sampled = ((struct loop_state *)called->described.loop.state)->chooser.sampled;
    size->calls = REST;
    redcc_back_off(&size->back_off, size->calls);
    size->phase = PHASE_BACK_OFF;
    size->rule = RULE_SLOWER;
    sampled[0] = 1;
    const long calls = size->calls, timed = size->sequential.count;
    for (int call = 1; call < REST; call++) {
        assert_false(call_right(called));
        assert_int_equal(statistics_of(called)->rule, RULE_SLOWER);
        assert_int_equal(size->calls, calls + call);
        assert_int_equal(size->sequential.count, timed + call);
        assert_int_equal(sampled[0] != 1, call == REST - 1);
    }
    assert_int_equal(atomic_load(&statistics_of(called)->fallback[REASON_SERIAL_FASTER]), REST - 1);
    assert_int_equal(size->phase, PHASE_BACK_OFF);
    call_right(called);
    assert_true(size->phase != PHASE_BACK_OFF);
}

/* Even shorter loops have no state; one word determines when they are timed again. */
static void short_loops_have_no_state(void **unused) {
    (void)unused;
    void *word = NULL;
    assert_true(redcc_is_unmade(word));
    assert_true(redcc_unmade_call(&word, 1000));
    assert_false(redcc_unmade_timed(&word, 1000, 1e-5));
    for (int calls = 16; calls < 4096; calls *= 2) {
        int between = 0; /* the last 16 calls are all counted, earlier ones one in 16 */
        for (; !redcc_unmade_call(&word, 1000); between++)
            assert_true(redcc_is_unmade(word) && between < calls + 32);
        assert_in_range(between, calls > 32 ? calls - 32 : 16, calls + 32);
        assert_false(redcc_unmade_timed(&word, 1000, 1e-5));
    }
    assert_false(redcc_unmade_call(&word, 10)); /* an even shorter loop */
    assert_true(redcc_unmade_call(&word, 1000000));
    assert_true(redcc_unmade_timed(&word, 1000000, 6e-3));
    struct loop_state *state = NULL; /* another thread has created the state */
    void *made = &state;
    assert_false(redcc_is_unmade(made));
    assert_true(redcc_unmade_call(&made, 1000));
    assert_true(redcc_unmade_timed(&made, 1000, 1e-5));
    assert_ptr_equal(made, &state);
}

/* Returns the number of executions that the loop's new state counts after the last of these
 * timings. Returns 0 if the loop gets no state, or -1 if it gets one before the last timing. */
static int executions_that_count(const double *seconds, int timings) {
    void *word = NULL;
    for (int timing = 0; timing < timings; timing++) {
        const int executions = redcc_unmade_timed(&word, 1000, seconds[timing]);
        if (executions > 0)
            return timing == timings - 1 ? executions : -1;
    }
    return 0;
}

/* A loop for which waking threads pays gets its state when it has taken 5 ms, and its executions
 * until then count. */
static void short_loops_get_a_state_late(void **unused) {
    (void)unused;
    static const struct {
        double seconds[3];
        int timings, executions;
    } asked[] = {{{5e-3}, 1, 1},
                 {{4.9e-3}, 1, 0},
                 {{4.9e-3, 4.9e-3}, 2, 2},
                 {{2e-3, 2e-3}, 2, 3},
                 {{0.5001e-3, 0.5001e-3}, 2, 10},
                 {{0.161e-3, 0.161e-3}, 2, 32},
                 {{2e-3, 0.3e-3}, 2, 0}, /* the first execution caused page faults */
                 {{2e-3, 0.3e-3, 0.3e-3}, 3, 16},
                 {{2e-3, 0.2e-3, 0.2e-3}, 3, 25},
                 /* the calls in between are assumed to take no longer than the first */
                 {{1e-3, 6e-3}, 2, 1},
                 {{0.15e-3, 0.2e-3}, 2, 0},
                 {{0.15e-3, 0.2e-3, 0.2e-3}, 3, 25},
                 {{0.15e-3, 0.15e-3, 0.15e-3}, 3, 0}};
    for (size_t a = 0; a < sizeof asked / sizeof *asked; a++)
        assert_int_equal(executions_that_count(asked[a].seconds, asked[a].timings),
                         asked[a].executions);
}

/* The calls that pass before the next timing count towards the 5 ms. */
static void calls_in_between_are_counted(void **unused) {
    (void)unused;
    void *word = NULL;
    int calls = 0;
    assert_int_equal(redcc_unmade_timed(&word, 1000, 0.5001e-3), 0);
    for (; !redcc_unmade_call(&word, 1000); calls++)
        assert_in_range(calls, 0, 7);
    assert_int_equal(calls, 8);
    assert_int_equal(redcc_unmade_timed(&word, 1000, 0.5001e-3), 10);
}

/* Executions of another size do not count. */
static void loops_of_other_sizes_earn_nothing(void **unused) {
    (void)unused;
    void *word = NULL;
    for (int timing = 0; timing < 10; timing++)
        assert_int_equal(redcc_unmade_timed(&word, timing == 0 ? 1000 : 10, 0.4e-3), 0);
    assert_int_equal(redcc_unmade_timed(&word, 1000, 0.4e-3), 0);
    assert_int_equal(redcc_unmade_timed(&word, 1000000, 4e-3), 0);
    assert_int_equal(redcc_unmade_timed(&word, 10, 6e-3), 1);
}

/* A program's first short iterations run without a call of the runtime. */
static void the_first_short_iterations_are_not_asked_about(void **unused) {
    (void)unused;
    redcc_least_trip = 1000;
    redcc_exempt_iterations = 5000;
    assert_false(redcc_is_worth_entering(999)); /* too few iterations, which are not counted */
    assert_false(redcc_is_worth_entering(2000));
    assert_false(redcc_is_worth_entering(2000));
    assert_true(redcc_is_worth_entering(1000));
    assert_true(redcc_is_worth_entering(1000));
    assert_false(redcc_is_worth_entering(999));
    redcc_exempt_iterations = 5000;
    assert_true(redcc_is_worth_entering(INT64_MAX));
    assert_true(redcc_is_worth_entering(1000));
    redcc_least_trip = redcc_exempt_iterations = 0;
}

/* A loop's first execution is timed before the loop has a state. The subscripts of the next call
 * are compared with those of this execution. */
static void subscripts_are_known_after_the_first_timing(void **fixture) {
    struct called *called = *fixture;
    const redcc_loop *loop = &called->described.loop;
    redcc_extent known[] = {
        {(const char *)called->problem.start, (const char *)(called->problem.start + TRIP + 1)},
        {(const char *)called->problem.row, (const char *)(called->problem.row + TRIP)},
        {0, 0},
        {0, 0}};
    struct chooser fresh = {0};
    redcc_advise_timed(&fresh, loop, known, TRIP, 1e-6);
    const uint64_t first = fresh.sampled[0];
    assert_true(first != 0 && first == redcc_reuse_sample(loop, known));
    called->problem.row[0]++;
    assert_true(redcc_reuse_sample(loop, known) != first);
    redcc_advise_timed(&fresh, loop, known, TRIP, 1e-6); /* the subscripts were sampled at entry */
    assert_true(fresh.sampled[0] == first && fresh.sampled[1] == 0);
}

/* All subscripts are compared once if that costs little. */
static void subscripts_are_compared(void **fixture) {
    struct called *called = *fixture;
    const redcc_extent known[] = {
        {(const char *)called->problem.start, (const char *)(called->problem.start + TRIP + 1)},
        {(const char *)called->problem.row, (const char *)(called->problem.row + TRIP)},
        {(const char *)called->problem.other, (const char *)(called->problem.other + TRIP)},
        {0, 0}};
    struct loop_state *state = called->described.loop.state;
    struct chooser *chooser = &state->chooser;
    redcc_advise_timed(chooser, &called->described.loop, known, TRIP, 1e-6);
    assert_false(chooser->remembered); /* would take more than a fiftieth of the loop */
    redcc_advise_timed(chooser, &called->described.loop, known, TRIP, 1);
    assert_true(chooser->remembered);
    struct fingerprint before = chooser->all, now;
    assert_true(redcc_reuse_fingerprint(&called->described.loop, known, 1, &now));
    assert_true(redcc_fingerprint_equal(before, now));
    /* fails, since the time limit is 0 */
    assert_false(redcc_reuse_fingerprint(&called->described.loop, known, 0, &now));
    called->problem.row[TRIP / 2 + 1]++;
    assert_true(redcc_reuse_fingerprint(&called->described.loop, known, 1, &now));
    assert_false(redcc_fingerprint_equal(before, now));
    const redcc_extent unknown[] = {known[0], {known[1].first, NULL}, known[2], {0, 0}};
    assert_false(redcc_reuse_fingerprint(&called->described.loop, unknown, 1, &now));
}

/* The first execution is timed before the loop has a state, so no decision has counted its call.
 * The number of calls so far is the number of uses expected of a plan. */
static void an_execution_counts_though_nothing_was_decided(void **unused) {
    (void)unused;
    static struct choice_state state;
    const struct situation now = {.trip = TRIP, .threads = 2, .wake = 1e-5};
    redcc_observe(&state,
                  &(struct outcome){.result = RESULT_SEQUENTIAL, .trip = TRIP, .seconds = 1});
    redcc_decide(&state, &now);
    assert_int_equal(redcc_size_of(&state, TRIP)->calls, 2);
}

/* Executions before the loop had a state are assumed to have taken as long as the timed one. */
static void executions_that_were_not_timed_count(void **unused) {
    (void)unused;
    static struct choice_state state;
    redcc_observe(&state,
                  &(struct outcome){
                      .result = RESULT_SEQUENTIAL, .trip = TRIP, .seconds = 0.3e-3, .untimed = 16});
    const struct size_state *size = redcc_size_of(&state, TRIP);
    assert_true(fabs(redcc_credit(&state) - 17 * 0.3e-3 / 32) < 1e-9);
    assert_true(fabs(size->set_ups.since - 17 * 0.3e-3) < 1e-9);
    assert_int_equal(size->calls, 16);
    assert_int_equal(size->sequential.count, 1);
}

/* 50,000 iterations of 2 touches, 20 ns each, on 2 threads. */
static const struct findings shuffled = {.trip = 50000,
                                         .threads = 2,
                                         .sequential = 20e-9,
                                         .share = 0.75,
                                         .touches = 2,
                                         .leading_rows = 2,
                                         .runs = 0.5,
                                         .reusable = true};

/* With one thread a plan is estimated to save time only if the loop has vector lanes, and never
 * with the access graph. */
static void one_thread_has_prospects_by_lanes(void **unused) {
    (void)unused;
    struct arm it[WAY_COUNT];
    struct findings findings = shuffled;
    findings.threads = 1;
    findings.share = 1;
    findings.runs = 0;
    redcc_estimate_arms(&findings, it);
    assert_true(it[WAY_INDEX].execution >= findings.sequential);
    findings.lanes = true;
    redcc_estimate_arms(&findings, it);
    assert_true(it[WAY_INDEX].execution < 0.9 * findings.sequential);
    assert_true(it[WAY_INDEX].execution > 0.8 * findings.sequential);
    assert_false(it[WAY_GRAPH].possible);
    struct arm two[WAY_COUNT]; /* with 2 threads the lanes change no estimate */
    findings.threads = 2;
    redcc_estimate_arms(&findings, it);
    findings.lanes = false;
    redcc_estimate_arms(&findings, two);
    assert_true(it[WAY_INDEX].execution == two[WAY_INDEX].execution);
}

static void prospects_follow_from_what_was_found(void **unused) {
    (void)unused;
    struct arm it[WAY_COUNT];
    struct findings findings = shuffled;
    redcc_estimate_arms(&findings, it);
    assert_false(it[WAY_COPIES].possible);
    assert_true(it[WAY_INDEX].possible && it[WAY_GRAPH].possible);
    assert_true(it[WAY_GRAPH].execution < it[WAY_INDEX].execution);
    assert_true(it[WAY_GRAPH].set_up > it[WAY_INDEX].set_up);
    findings.copied = 1e5; /* 15 microseconds of 500 */
    redcc_estimate_arms(&findings, it);
    assert_true(it[WAY_COPIES].execution < it[WAY_GRAPH].execution);
    findings.copied = 1e7;
    redcc_estimate_arms(&findings, it);
    assert_true(it[WAY_COPIES].execution > findings.sequential);
    findings.reusable = false; /* each execution needs an inspection */
    redcc_estimate_arms(&findings, it);
    assert_false(it[WAY_GRAPH].possible);
    assert_true(it[WAY_INDEX].execution > findings.sequential);
    findings = shuffled;
    findings.fetched = true; /* an execution by a plan waits less for memory than the loop */
    struct arm fetched[WAY_COUNT];
    redcc_estimate_arms(&findings, fetched);
    findings.fetched = false;
    redcc_estimate_arms(&findings, it);
    assert_true(fetched[WAY_INDEX].execution < 0.8 * it[WAY_INDEX].execution);
    assert_true(fetched[WAY_GRAPH].execution < 0.8 * it[WAY_GRAPH].execution);
    assert_true(fetched[WAY_GRAPH].set_up == it[WAY_GRAPH].set_up);
    findings = shuffled;
    /* an inspection evaluates the slice once per iteration; binning may do so, too */
    findings.slice.recorded = 100e-9;
    redcc_estimate_arms(&findings, fetched);
    assert_true(fetched[WAY_INDEX].set_up > it[WAY_INDEX].set_up + 2e-3);
    assert_true(fetched[WAY_GRAPH].set_up > it[WAY_GRAPH].set_up + 2e-3);
    findings.binned = true;
    redcc_estimate_arms(&findings, it);
    findings.bin_more = 2.5e-3;
    redcc_estimate_arms(&findings, fetched);
    assert_true(fetched[WAY_BINS].execution > it[WAY_BINS].execution + 40e-9);
    findings = shuffled;
    findings.runs = 0; /* sorted */
    findings.share = 0.51;
    redcc_estimate_arms(&findings, it);
    assert_false(it[WAY_GRAPH].possible);
    assert_true(it[WAY_INDEX].execution < 0.6 * findings.sequential);
    findings.sequential = 1e-9; /* short iterations, each with other owners than the previous one */
    findings.runs = 1;
    redcc_estimate_arms(&findings, it);
    assert_true(it[WAY_INDEX].execution > findings.sequential);
}

/* Threads are started concurrently, and they wait concurrently for their time slices. */
static void many_threads_start_as_soon_as_few(void **unused) {
    (void)unused;
    const double one = redcc_start_seconds(1, false), many = redcc_start_seconds(15, false);
    assert_true(0.1e-3 <= one && one <= 1e-3);
    assert_true(one < many && many < 4 * one);
    assert_true(redcc_start_seconds(1, true) >= 2e-3);
    assert_true(redcc_start_seconds(15, true) == redcc_start_seconds(1, true));
    /* earlier parallel regions of the program have started the threads */
    assert_true(redcc_start_seconds(0, true) < one);
    struct chooser chooser = {0};
    redcc_tell_team(&chooser, 4, 4, 0.6e-3, 3);
    assert_true(fabs(redcc_start_seconds(15, false) - 15 * 0.2e-3) < 1e-9);
    assert_true(redcc_start_seconds(15, true) >= 4e-3);
    /* the threads waited for cores, so starting takes this long */
    redcc_tell_team(&chooser, 4, 4, 15e-3, 3);
    assert_true(fabs(redcc_start_seconds(3, true) - 15e-3) < 1e-9);
    redcc_tell_team(&chooser, 2, 2, 0.4e-3, 1); /* restores the state for later tests */
}

/* 1000 iterations of a loop over pairs, in `executions` of 1.6 ms. */
static struct choice_state after_pairs(int executions) {
    struct choice_state state = {0};
    for (int n = 0; n < executions; n++)
        redcc_observe(&state, &(struct outcome){
                                  .result = RESULT_SEQUENTIAL, .trip = 1000, .seconds = 1.6e-3});
    return state;
}

static struct situation pairs_now(double start) {
    return (struct situation){.trip = 1000,
                              .threads = 2,
                              .wake = 10e-6,
                              .start = start,
                              .tiled = true,
                              .in_tiles = true,
                              .kept = {[WAY_DIRECT] = KEPT_FITS, [WAY_BINS] = KEPT_FITS}};
}

static const struct outcome slow_tiles = {.result = RESULT_PARALLEL,
                                          .way = WAY_DIRECT,
                                          .trip = 1000,
                                          .seconds = 2.5e-3,
                                          .set_up = 0.5e-3};

/* No sample is taken: the second execution uses tiles if that repays starting the threads at once.
 */
static void pairs_begin_with_tiles(void **unused) {
    (void)unused;
    struct choice_state state = after_pairs(1);
    struct situation now = pairs_now(0.4e-3);
    struct decision decision = redcc_decide(&state, &now);
    assert_int_equal(decision.action, ACTION_REUSE);
    assert_int_equal(decision.way, WAY_DIRECT);
    state = after_pairs(1);
    now = pairs_now(4e-3); /* other programs use the cores */
    assert_int_equal(redcc_decide(&state, &now).action, ACTION_SEQUENTIAL);
    state = after_pairs(1);
    now = pairs_now(0.4e-3);
    now.threads = 1;
    assert_int_equal(redcc_decide(&state, &now).action, ACTION_SEQUENTIAL);
    state = after_pairs(1);
    now = pairs_now(0.4e-3);
    now.in_tiles = false; /* a loop over blocks */
    assert_int_equal(redcc_decide(&state, &now).action, ACTION_SEQUENTIAL);
}

/* A slow first execution with new threads does not stop a loop that has run several times: it
 * continues with the threads at once. */
static void tiles_go_on_after_a_slow_beginning(void **unused) {
    (void)unused;
    struct choice_state state = after_pairs(4);
    struct situation now = pairs_now(0.4e-3);
    assert_int_equal(redcc_decide(&state, &now).action, ACTION_REUSE);
    redcc_observe(&state, &slow_tiles);
    assert_true(state.ledger.overhead <= 1.25 * 1.6e-3);
    now.start = 0;
    assert_int_equal(redcc_decide(&state, &now).action, ACTION_REUSE);
    redcc_observe(&state,
                  &(struct outcome){
                      .result = RESULT_PARALLEL, .way = WAY_DIRECT, .trip = 1000, .seconds = 1e-3});
    assert_int_equal(redcc_size_of(&state, 1000)->phase, PHASE_PARALLEL);
    state = after_pairs(1); /* a new loop waits */
    now.start = 0.4e-3;
    assert_int_equal(redcc_decide(&state, &now).action, ACTION_REUSE);
    redcc_observe(&state, &slow_tiles);
    assert_int_equal(redcc_decide(&state, &now).action, ACTION_SEQUENTIAL);
}

/* If a guard forbids tiles, a sample may find another strategy. */
static void a_sample_follows_tiles_that_failed(void **unused) {
    (void)unused;
    struct choice_state state = after_pairs(40);
    struct situation now = pairs_now(0);
    assert_int_equal(redcc_decide(&state, &now).action, ACTION_REUSE);
    redcc_observe(&state,
                  &(struct outcome){.result = RESULT_REFUSED, .way = WAY_DIRECT, .trip = 1000});
    struct decision decision = {.action = ACTION_SEQUENTIAL};
    for (int call = 0; call < 40 && decision.action == ACTION_SEQUENTIAL; call++) {
        decision = redcc_decide(&state, &now);
        if (decision.action == ACTION_SEQUENTIAL)
            redcc_observe(
                &state,
                &(struct outcome){.result = RESULT_SEQUENTIAL, .trip = 1000, .seconds = 1.6e-3});
    }
    assert_int_equal(decision.action, ACTION_INSPECT);
}

static void few_short_iterations_are_one_threads(void **unused) {
    (void)unused;
    assert_int_equal(redcc_advise_threads(20, 2, 0, 0), 1); /* nothing is known yet */
    assert_int_equal(redcc_advise_threads(4095, 7, 0, 0), 1);
    assert_int_equal(redcc_advise_threads(4096, 7, 0, 0), 7);
    assert_int_equal(redcc_advise_threads(20, 2, 1e-6, 1), 1);
    assert_int_equal(redcc_advise_threads(20, 2, 1e-3, 10), 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        /* must come first, before any thread has been started */
        cmocka_unit_test(many_threads_start_as_soon_as_few),
        cmocka_unit_test_setup_teardown(the_first_call_is_sequential_and_timed, begin_sorted, end),
        cmocka_unit_test_setup_teardown(one_thread_is_enough_for_lanes, begin_sorted, end),
        cmocka_unit_test_setup_teardown(nothing_is_begun_without_credit, begin_shuffled, end),
        cmocka_unit_test_setup_teardown(a_heavy_loop_is_set_up, begin_sorted, end),
        cmocka_unit_test_setup_teardown(changed_subscripts_are_not_inspected_at_once, begin_sorted,
                                        end),
        cmocka_unit_test_setup_teardown(a_sample_that_took_long_is_not_lost, begin_sorted, end),
        cmocka_unit_test_setup_teardown(an_inspection_ends_at_its_deadline, begin_shuffled, end),
        cmocka_unit_test_setup_teardown(an_expensive_slice_is_seen, begin_sorted, end),
        cmocka_unit_test_setup_teardown(short_loops_are_left_alone, begin_sorted, end),
        cmocka_unit_test_setup_teardown(resting_loops_are_left_alone, begin_sorted, end),
        cmocka_unit_test(short_loops_have_no_state),
        cmocka_unit_test_setup_teardown(subscripts_are_known_after_the_first_timing, begin_sorted,
                                        end),
        cmocka_unit_test_setup_teardown(subscripts_are_compared, begin_sorted, end),
        cmocka_unit_test(short_loops_get_a_state_late),
        cmocka_unit_test(calls_in_between_are_counted),
        cmocka_unit_test(loops_of_other_sizes_earn_nothing),
        cmocka_unit_test(executions_that_were_not_timed_count),
        cmocka_unit_test(the_first_short_iterations_are_not_asked_about),
        cmocka_unit_test(an_execution_counts_though_nothing_was_decided),
        cmocka_unit_test(one_thread_has_prospects_by_lanes),
        cmocka_unit_test(prospects_follow_from_what_was_found),
        cmocka_unit_test(few_short_iterations_are_one_threads),
        cmocka_unit_test(pairs_begin_with_tiles),
        cmocka_unit_test(tiles_go_on_after_a_slow_beginning),
        cmocka_unit_test(a_sample_follows_tiles_that_failed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
