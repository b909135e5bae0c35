/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* auto on real loops: what it has its calls do, with the bits of the original loop each time; and
 * its decision table in docs/methods.md. The bounds themselves are test_choose_bound's. */
#include "loop.h"

#include "base/memory.h"
#include "choose/prospects.h"
#include "problem.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { TRIP = 200000, ROWS = 50000, THREADS = 2 };

/* Each iteration touches one row: in order, or at random. */
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

/* One call, with the oracle's bits; returns whether the runtime executed it. */
static bool call_right(struct problem *problem, struct described *described) {
    static double expected[ROWS];
    long last;
    problem_reset(problem);
    problem_oracle(problem);
    memcpy(expected, problem->first, sizeof expected);
    problem_reset(problem);
    const int done = problem_run(problem, described, THREADS, &last);
    assert_memory_equal(expected, problem->first, sizeof expected);
    return done;
}

static struct statistics *statistics_of(struct described *described) {
    return &((struct loop_state *)described->loop.state)->reported.statistics;
}

static struct size_state *size_of(struct described *described) {
    struct loop_state *state = described->loop.state;
    return &state->chooser.state.size[63 - __builtin_clzll(TRIP)];
}

static void begin(struct problem *problem, struct described *described, bool sorted) {
    *problem = one_touch_each(sorted);
    problem_run_tells = false;
    problem_describe(problem, described);
}

static void end(struct problem *problem, struct described *described) {
    redcc_loop_forget(&described->loop);
    problem_free(problem);
    assert_int_equal(redcc_memory_live(), 0);
}

static void the_first_call_is_sequential_and_timed(void **unused) {
    (void)unused;
    struct problem problem;
    struct described described;
    begin(&problem, &described, true);
    assert_false(call_right(&problem, &described));
    assert_int_equal(statistics_of(&described)->rule, RULE_FIRST);
    assert_int_equal(size_of(&described)->sequential.count, 1);
    assert_true(size_of(&described)->sequential.recent[0] > 0);
    end(&problem, &described);
}

/* Nothing is begun while it may cost more than a tenth of the time so far. */
static void nothing_is_begun_without_credit(void **unused) {
    (void)unused;
    struct problem problem;
    struct described described;
    begin(&problem, &described, false);
    for (int call = 0; call < 10; call++)
        assert_false(call_right(&problem, &described));
    const struct loop_state *state = described.loop.state;
    const struct ledger *ledger = &state->chooser.state.ledger;
    assert_int_equal(statistics_of(&described)->plans_built, 0);
    assert_true(ledger->sequential > 0);
    end(&problem, &described);
}

/* Iterations that take long: a plan as soon as that is known, and it is used again. */
static void a_heavy_loop_is_set_up(void **unused) {
    (void)unused;
    struct problem problem;
    struct described described;
    begin(&problem, &described, true);
    assert_false(call_right(&problem, &described));
    problem_tell_slow(&described.loop, TRIP, 1e-6);
    assert_true(call_right(&problem, &described));
    assert_int_equal(statistics_of(&described)->plans_built, 1);
    for (int call = 0; call < 5; call++)
        assert_true(call_right(&problem, &described));
    assert_int_equal(statistics_of(&described)->plans_built, 1);
    assert_int_equal(statistics_of(&described)->plans_reused, 5);
    assert_int_equal(size_of(&described)->stand, STAND_PARALLEL);
    end(&problem, &described);
}

/* Other subscripts: the original loop, and another plan only when the credit allows it. */
static void changed_subscripts_are_not_inspected_at_once(void **unused) {
    (void)unused;
    struct problem problem;
    struct described described;
    begin(&problem, &described, true);
    assert_false(call_right(&problem, &described));
    problem_tell_slow(&described.loop, TRIP, 1e-6);
    assert_true(call_right(&problem, &described));
    assert_true(call_right(&problem, &described));
    struct loop_state *state = described.loop.state;
    state->chooser.state.ledger.overhead = 1e9;
    problem.row[TRIP / 2 + 1] = 0; /* which the sample does not see */
    state->chooser.state.ledger.overhead =
        0.1 * state->chooser.state.ledger.sequential -
        0.5e-6 * (double)TRIP; /* an execution, no set-up's factor */
    size_of(&described)->set_ups.factor = 1e6;
    assert_false(call_right(&problem, &described));
    assert_int_equal(statistics_of(&described)->rule, RULE_CHANGED);
    assert_int_equal(atomic_load(&statistics_of(&described)->fallback[REASON_CHANGED]), 1);
    assert_int_equal(statistics_of(&described)->plans_built, 1);
    for (int t = 0; t < TRIP; t++) /* which it does see */
        problem.row[t] = (problem.row[t] + 1) % ROWS;
    assert_false(call_right(&problem, &described));
    assert_int_equal(statistics_of(&described)->plans_built, 1);
    end(&problem, &described);
}

/* An inspection whose deadline has come: the arrays are as they were, and its cost is learned. */
static void an_inspection_ends_at_its_deadline(void **unused) {
    (void)unused;
    struct problem problem;
    struct described described;
    begin(&problem, &described, false);
    assert_false(call_right(&problem, &described));
    problem_tell_slow(&described.loop, TRIP, 1e-6);
    struct size_state *size = size_of(&described);
    size->looked = true;
    size->prospect[WAY_INDEX] =
        (struct prospect){.possible = true, .set_up = 1e-9, .learned = 1e-9, .execution = 1e-8};
    assert_false(call_right(&problem, &described));
    assert_int_equal(statistics_of(&described)->rule, RULE_STOPPED);
    assert_int_equal(atomic_load(&statistics_of(&described)->fallback[REASON_DEADLINE]), 1);
    assert_int_equal(statistics_of(&described)->plans_built, 0);
    assert_true(size->prospect[WAY_INDEX].learned > 1e-6 || size->look > 1e-6);
    for (int call = 0; call < 10 && statistics_of(&described)->plans_built == 0; call++)
        call_right(&problem, &described); /* each stop doubles what is known of the cost */
    end(&problem, &described);
}

/* Short loops are left alone, by a compare and a counter. */
static void short_loops_are_left_alone(void **unused) {
    (void)unused;
    struct problem problem;
    struct described described;
    begin(&problem, &described, true);
    assert_false(call_right(&problem, &described));
    for (int i = 0; i < 3; i++)
        size_of(&described)->sequential.recent[i] = 1e-12;
    for (int call = 0; call < 10; call++) {
        assert_false(call_right(&problem, &described));
        assert_int_equal(statistics_of(&described)->rule, RULE_SHORT);
    }
    assert_int_equal(size_of(&described)->stand, STAND_SHORT);
    assert_int_equal(atomic_load(&statistics_of(&described)->fallback[REASON_LITTLE_WORK]), 10);
    end(&problem, &described);
}

/* 50,000 iterations of 2 touches, 20 ns each, on 2 threads. */
static const struct findings shuffled = {.trip = 50000,
                                         .threads = 2,
                                         .sequential = 20e-9,
                                         .share = 0.75,
                                         .touches = 2,
                                         .runs = 0.5,
                                         .reusable = true};

static void prospects_follow_from_what_was_found(void **unused) {
    (void)unused;
    struct prospect it[WAY_COUNT];
    struct findings findings = shuffled;
    redcc_estimate_prospects(&findings, it);
    assert_false(it[WAY_COPIES].possible);
    assert_true(it[WAY_INDEX].possible && it[WAY_GRAPH].possible);
    assert_true(it[WAY_GRAPH].execution < it[WAY_INDEX].execution);
    assert_true(it[WAY_GRAPH].set_up > 3 * it[WAY_INDEX].set_up);
    findings.copies = true;
    findings.copied = 1e5; /* 15 microseconds of 500 */
    redcc_estimate_prospects(&findings, it);
    assert_true(it[WAY_COPIES].execution < it[WAY_GRAPH].execution);
    findings.copied = 1e7;
    redcc_estimate_prospects(&findings, it);
    assert_true(it[WAY_COPIES].execution > findings.sequential);
    findings.reusable = false; /* each execution inspects */
    redcc_estimate_prospects(&findings, it);
    assert_false(it[WAY_GRAPH].possible);
    assert_true(it[WAY_INDEX].execution > findings.sequential);
    findings = shuffled;
    findings.runs = 0; /* sorted */
    findings.share = 0.51;
    redcc_estimate_prospects(&findings, it);
    assert_false(it[WAY_GRAPH].possible);
    assert_true(it[WAY_INDEX].execution < 0.6 * findings.sequential);
    findings.sequential = 1e-9; /* a light loop whose iterations all have other owners */
    findings.runs = 1;
    redcc_estimate_prospects(&findings, it);
    assert_true(it[WAY_INDEX].execution > findings.sequential);
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
        cmocka_unit_test(the_first_call_is_sequential_and_timed),
        cmocka_unit_test(nothing_is_begun_without_credit),
        cmocka_unit_test(a_heavy_loop_is_set_up),
        cmocka_unit_test(changed_subscripts_are_not_inspected_at_once),
        cmocka_unit_test(an_inspection_ends_at_its_deadline),
        cmocka_unit_test(short_loops_are_left_alone),
        cmocka_unit_test(prospects_follow_from_what_was_found),
        cmocka_unit_test(few_short_iterations_are_one_threads),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
