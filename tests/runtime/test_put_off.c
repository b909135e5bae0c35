/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* auto and a light loop of which every iteration has another owner than the last: what an
 * inspection takes is awaited before it is spent. */
#include "base/memory.h"
#include "choose/budget.h"
#include "loop.h"
#include "problem.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { TRIP = 200000, ROWS = 1000, THREADS = 2 }; /* inspecting is reckoned at 2 ms */

static struct problem one_touch_each(void) {
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
        problem.row[t] = (int)(next_random(&random) % ROWS);
        problem.other[t] = 0;
        problem.value[t] = (double)(next_random(&random) % 100) / 3.0;
    }
    problem.start[TRIP] = TRIP;
    return problem;
}

/* One call, with the oracle's bits; returns whether the runtime executed it. */
static int call_right(struct problem *problem, struct described *described) {
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

static void an_inspection_waits_for_the_budget(void **unused) {
    (void)unused;
    struct problem problem = one_touch_each();
    struct described described;
    problem_describe(&problem, &described);
    redcc_budget_gain(-1e6);
    assert_true(call_right(&problem, &described)); /* by one thread, timed */
    struct loop_state *state = described.loop.state;
    const struct statistics *statistics = &state->reported.statistics;
    assert_int_equal(statistics->rule, RULE_TIMED);
    assert_int_equal(statistics->plans_built, 0);
    struct trial *trial = &state->chooser.trial[17]; /* of 2^17 to 2^18 iterations */
    assert_true(trial->serial_best > 0);
    trial->serial_best = 1e-9;
    for (int call = 0; call < 3; call++) {
        assert_false(call_right(&problem, &described));
        assert_int_equal(statistics->rule, RULE_COSTLY);
    }
    assert_int_equal(atomic_load(&statistics->fallback[REASON_COSTLY]), 4);
    redcc_budget_gain(2e6);
    assert_true(call_right(&problem, &described));
    assert_int_equal(statistics->plans_built, 1);
    redcc_budget_gain(-1e6);
    redcc_loop_forget(&described.loop);
    problem_free(&problem);
    assert_int_equal(redcc_memory_live(), 0);
}

/* A loop that takes long beside its inspection is inspected as soon as that is known. */
static void a_heavy_loop_does_not_wait(void **unused) {
    (void)unused;
    struct problem problem = one_touch_each();
    struct described described;
    problem_describe(&problem, &described);
    redcc_budget_gain(-1e6);
    assert_true(call_right(&problem, &described));
    struct loop_state *state = described.loop.state;
    state->chooser.trial[17].serial_best = 1e-6;
    assert_true(call_right(&problem, &described));
    assert_int_equal(state->reported.statistics.plans_built, 1);
    redcc_budget_gain(1e6);
    redcc_loop_forget(&described.loop);
    problem_free(&problem);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_inspection_waits_for_the_budget),
        cmocka_unit_test(a_heavy_loop_does_not_wait),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
