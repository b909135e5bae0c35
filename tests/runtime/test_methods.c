/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The method that REDCC_METHOD names is compared with the sequential loop, on loops of every form
 * and with many thread counts. The bits must be equal if the method promises it or the values are
 * exact. */
#include "base/memory.h"
#include "loop.h"
#include "plan_check.h"
#include "problem.h"
#include "settings.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const int thread_counts[] = {1, 2, 3, 7, 16, 33, 64};
enum { MANY = 64 }; /* used for a third of the loops only, since so many threads are slow */

static void copy_arrays(const struct problem *problem, double *to) {
    memcpy(to, problem->first, (size_t)problem->doubles * sizeof *to);
    if (problem->second && !problem->second_in_first)
        memcpy(to + problem->doubles, problem->second,
               (size_t)problem->second_rows * (size_t)problem->second_width * sizeof *to);
}

static size_t all_doubles(const struct problem *problem) {
    return (size_t)problem->doubles + (size_t)problem->second_rows * (size_t)problem->second_width;
}

/* Does a plan execute the named method with this number of threads? */
static bool plans(const struct settings *settings, int threads) {
    return settings->method && settings->method->prepare &&
           (threads > 1 || settings->compensated || settings->method->keeps == REDCC_ORDER_FIXED);
}

static void try_problem(int number, bool exact, int threads) {
    const struct settings *settings = redcc_settings();
    struct problem problem = problem_new(number, exact);
    struct described described;
    problem_describe(&problem, &described);
    if (!settings->method && settings->order_given)
        described.loop.order = settings->order;
    double *expected = calloc(all_doubles(&problem) + 1, sizeof *expected);
    double *found = calloc(all_doubles(&problem) + 1, sizeof *found);
    problem_oracle(&problem);
    copy_arrays(&problem, expected);
    for (int call = 0; call < 4; call++) {
        long last = -1;
        problem_reset(&problem);
        const int parallel = problem_run(&problem, &described, threads, &last);
        copy_arrays(&problem, found);
        if (memcmp(expected, found, all_doubles(&problem) * sizeof *found) != 0)
            fail_msg("%s, %d threads, call %d: the bits differ", problem.name, threads, call);
        assert_int_equal(last, problem.trip > 0 ? 3 * problem.trip - 2 : -1);
        if (settings->method && settings->method->prepare)
            assert_int_equal(parallel, plans(settings, threads) && problem.trip > 0);
    }
    const struct loop_state *state = described.loop.state;
    const struct statistics *statistics = &state->reported.statistics;
    if (plans(settings, threads) && problem.trip > 0) {
        assert_int_equal(statistics->plans_built, 1);
        assert_int_equal(statistics->plans_reused, 3);
        check_plan(&problem, state->cache.kept[0]->plan);
    }
    redcc_loop_forget(&described.loop);
    problem_free(&problem);
    free(expected);
    free(found);
    assert_int_equal(redcc_memory_live(), 0);
}

static void all_shapes(bool exact) {
    for (int number = 0; number < PROBLEMS; number++)
        for (size_t i = 0; i < sizeof thread_counts / sizeof *thread_counts; i++)
            if (thread_counts[i] < MANY || number % 3 == 1)
                try_problem(number, exact, thread_counts[i]);
}

static void exact_values_give_the_oracles_bits(void **unused) {
    (void)unused;
    all_shapes(true);
}

static void methods_that_keep_the_order_give_the_oracles_bits(void **unused) {
    (void)unused;
    const struct settings *settings = redcc_settings();
    const redcc_order order = settings->method        ? settings->method->keeps
                              : settings->order_given ? settings->order
                                                      : REDCC_ORDER_SERIAL;
    if (order != REDCC_ORDER_SERIAL || settings->compensated)
        skip();
    all_shapes(false);
}

/* With shuffled subscripts into a few thousand elements, private copies cost less than replicated
 * iterations. */
static void auto_takes_copies_where_they_are_cheaper(void **unused) {
    (void)unused;
    const struct settings *settings = redcc_settings();
    if (settings->method || settings->compensated || settings->order != REDCC_ORDER_ANY)
        skip();
    struct problem problem = problem_new(1, true);
    struct described described;
    long last;
    problem_describe(&problem, &described);
    assert_false(problem_run(&problem, &described, 2, &last));
    assert_true(problem_run(&problem, &described, 2, &last));
    const struct loop_state *state = described.loop.state;
    assert_ptr_equal(state->cache.kept[0]->plan->method, &redcc_method_expansion);
    redcc_loop_forget(&described.loop);
    problem_free(&problem);
}

/* An iteration that the sample misses touches an element far away, so copies would exceed the
 * memory limit. */
static void copies_that_turn_out_too_large_are_not_taken(void **unused) {
    (void)unused;
    const size_t limit = redcc_settings()->memory_limit;
    if (limit == 0)
        skip();
    struct problem problem = problem_new(1, true);
    struct described described;
    long last;
    free(problem.first);
    problem.rows = (int)(limit / sizeof(double));
    problem.doubles = problem.rows;
    problem.row[problem.start[1]] = problem.rows - 1;
    problem.first = malloc((size_t)problem.doubles * sizeof(double));
    double *expected = malloc((size_t)problem.doubles * sizeof(double));
    problem_describe(&problem, &described);
    problem_reset(&problem);
    problem_oracle(&problem);
    memcpy(expected, problem.first, (size_t)problem.doubles * sizeof(double));
    problem_reset(&problem);
    assert_false(problem_run(&problem, &described, 2, &last));
    int done = 0; /* the graph lacks memory, too, as the first plan construction finds */
    for (int call = 0; call < 10 && !done; call++) {
        problem_reset(&problem);
        done = problem_run(&problem, &described, 2, &last);
    }
    assert_true(done);
    assert_memory_equal(expected, problem.first, (size_t)problem.doubles * sizeof(double));
    const struct loop_state *state = described.loop.state;
    assert_ptr_equal(state->cache.kept[0]->plan->method, &redcc_method_localwrite);
    assert_int_equal(state->cache.kept[0]->plan->owners, 2);
    redcc_loop_forget(&described.loop);
    problem_free(&problem);
    free(expected);
    assert_int_equal(redcc_memory_live(), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exact_values_give_the_oracles_bits),
        cmocka_unit_test(methods_that_keep_the_order_give_the_oracles_bits),
        cmocka_unit_test(auto_takes_copies_where_they_are_cheaper),
        cmocka_unit_test(copies_that_turn_out_too_large_are_not_taken),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
