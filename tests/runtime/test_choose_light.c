/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* auto on simulated light loops: how often it takes samples, constructs plans and executes in
 * parallel, and that no prefix of a run becomes slower than the bound (docs/choosing.md). */
#include "choose_traces.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

/* Checks a loop of 2.5 ms whose sample takes 0.5 ms and whose threads take 6 ms to start.
 * Executions by a plan are expected to take 0.63 of the sequential time, and take `execution`. Plan
 * constructions take `error` times the expected time. The subscripts change every `every` calls.
 * The loop must not be slower from the first call on. */
static void check_light(const char *name, double execution, double error, int every) {
    struct trace *trace = ordinary(400);
    trace->look = 0.5e-3;
    trace->start = 6e-3;
    trace->set_up[WAY_INDEX] = 4e-9;
    trace->set_up[WAY_GRAPH] = 12e-9;
    trace->set_up_error = 1 / error;
    trace->execution_error = 0.63 / execution;
    for (int c = 0; c < trace->count; c++) {
        struct simulated_call *call = &trace->call[c];
        call->sequential = c ? 2.5e-3 : 3.5e-3;
        call->execution[WAY_INDEX] = call->execution[WAY_GRAPH] = execution * 2.5e-3;
        call->subscripts = c / every;
    }
    const struct simulated it = simulate(trace);
    if (getenv("CHOOSE_SHOW"))
        printf("%s: slowest %.4f, looks %d, set-ups %d\n", name, it.slowest, it.looks, it.set_ups);
    if (it.slowest > 1 / 0.95)
        fail_msg("%s: %.4f times the sequential program's time", name, it.slowest);
    if (it.set_ups > (every == 1 ? 0 : 3))
        fail_msg("%s: %d set-ups", name, it.set_ups);
    assert_int_equal(it.looks, 1);
    free(trace);
}

/* No plan is constructed if starting the threads alone would cost more than trials may cost. */
static void check_threads_that_start_slowly(void) {
    struct trace *trace = ordinary(400);
    trace->start = 0.2;
    const struct simulated it = simulate(trace);
    assert_int_equal(it.looks, 1);
    assert_int_equal(it.set_ups, 0);
    free(trace);
}

static void light_loops(void **unused) {
    (void)unused;
    check_threads_that_start_slowly();
    check_light("light", 0.63, 1, 1000);
    check_light("light, no gain", 1.05, 1, 1000);
    check_light("light, no gain, set-ups three times as long", 1.05, 3, 1000);
    check_light("light, other subscripts each call", 0.63, 1, 1);
    check_light("light, other subscripts each call, no gain", 1.05, 3, 1);
}

/* Sets the seconds of each execution: sequentially, and by a plan. */
static void set_all(struct trace *trace, double sequential, double by_plan) {
    for (int c = 0; c < trace->count; c++) {
        trace->call[c].sequential = sequential;
        trace->call[c].execution[WAY_INDEX] = by_plan;
    }
}

/* Returns a light loop whose sampled subscripts stay the same: 2.5 ms per execution, half of that
 * by a plan, whose construction takes 2.5 ms. */
static struct trace *light(int count) {
    struct trace *trace = ordinary(count);
    trace->possible[WAY_GRAPH] = false;
    trace->set_up[WAY_INDEX] = 1.2e-9;
    trace->look = 0.2e-3;
    trace->start = 0.1e-3;
    set_all(trace, 2.5e-3, 1.25e-3);
    return trace;
}

/* At first each execution takes 0.94 of the time of the preceding one, and finally half of the
 * first one's time. A plan gains less than expected, but repays its construction. */
static void a_loop_that_becomes_faster(void **unused) {
    (void)unused;
    for (int count = 10; count <= 40; count += 30) {
        struct trace *trace = light(count);
        trace->set_up[WAY_INDEX] = 0.8e-9;
        for (int c = 0; c < count; c++) {
            const double as_long = fmax(pow(0.94, c), 0.5);
            scale(&trace->call[c], as_long, as_long);
        }
        const struct simulated it = simulate(trace);
        assert_int_equal(it.set_ups, 1);
        assert_in_range(it.parallel, count - 8, count - 4);
        assert_true(it.total < (count > 10 ? 0.75 : 1) * it.sequential);
        free(trace);
    }
}

/* A loop of 0.3 ms, for which a sample is expensive: the credit covers it after some tens of
 * executions, and then an overdraft does. If waking threads takes a sixteenth of a loop's time, the
 * loop stays sequential. */
static void short_loops(void **unused) {
    (void)unused;
    for (int again = 0; again < 2; again++) {
        struct trace *trace = light(1000);
        trace->look = 0.12e-3;
        trace->set_up[WAY_INDEX] = 0.1e-9;
        trace->wake = again ? 20e-6 : 10e-6;
        set_all(trace, 0.3e-3, 0.17e-3);
        const struct simulated it = simulate(trace);
        assert_true(it.slowest < 1.04);
        assert_int_equal(it.looks, again ? 0 : 1);
        assert_int_equal(it.set_ups, again ? 0 : 1);
        assert_in_range(it.parallel, again ? 0 : 955, again ? 0 : 975);
        free(trace);
    }
}

/* In all calls but the one with the sample, the loop is found to be sequential without a query
 * about threads. These are calls that save for the sample, or calls of a loop whose threads or
 * plans cost too much. */
static void little_is_asked(void **unused) {
    (void)unused;
    struct trace *trace = light(40);
    trace->look = 0.35e-3;
    trace->start = 1;
    const struct simulated slow = simulate(trace);
    assert_int_equal(slow.looks, 1);
    assert_int_equal(slow.left_alone, 39);
    trace->set_up[WAY_INDEX] = 1e-6;
    const struct simulated expensive = simulate(trace);
    assert_int_equal(expensive.looks, 1);
    assert_int_equal(expensive.left_alone, 39);
    free(trace);
}

/* Executions of 14 ms whose subscripts are compared. The second call has enough credit to inspect a
 * sample, and may exceed it to start the threads. So the plan is constructed at once. */
static void threads_are_lent_for_a_look(void **unused) {
    (void)unused;
    struct trace *trace = light(10);
    trace->compared = true;
    trace->start = 0.4e-3;
    set_all(trace, 14e-3, 7e-3);
    const struct simulated it = simulate(trace);
    assert_int_equal(it.looks, 0);
    assert_int_equal(it.set_ups, 1);
    assert_int_equal(it.parallel, 9);
    free(trace);
}

/* Time spent waiting for threads does not end the inspection: the threads exist now. */
static void threads_that_start_late_for_a_light_loop(void **unused) {
    (void)unused;
    struct trace *trace = light(40);
    trace->late = 3e-3;
    const struct simulated it = simulate(trace);
    assert_int_equal(it.set_ups, 1);
    assert_in_range(it.parallel, 32, 36);
    assert_true(it.total < 0.7 * it.sequential);
    free(trace);
}

/* The plan construction took longer than expected and left a debt. Only a plan that is clearly
 * faster may repay it. */
static void a_plan_that_repays(void **unused) {
    (void)unused;
    struct trace *trace = light(40);
    trace->overrun = 5e-3;
    const struct simulated faster = simulate(trace);
    assert_int_equal(faster.set_ups, 1);
    assert_in_range(faster.parallel, 32, 36);
    const int first = trace->count - faster.parallel;
    /* an interruption, but all executions together still gain */
    trace->call[first + 2].execution[WAY_INDEX] = 3.2e-3;
    assert_int_equal(simulate(trace).parallel, faster.parallel);
    for (int c = first + 1; c < trace->count; c++)
        trace->call[c].execution[WAY_INDEX] = 3.8e-3;
    assert_int_equal(simulate(trace).parallel, 2);
    free(trace);
}

/* Page faults make the first execution without a plan slow: it gains 15 % where later ones gain 35
 * %. A second one follows at once, although the first was not clearly faster and the sample has
 * left a debt. It also follows if the first execution has lost a little, as on a busy machine; if
 * it has lost much, the loop waits. */
static void a_first_execution_that_is_slow(void **unused) {
    (void)unused;
    struct trace *trace = light(31);
    trace->possible[WAY_INDEX] = false;
    trace->possible[WAY_DIRECT] = true;
    trace->start = 3.5e-3;
    for (int c = 0; c < trace->count; c++) {
        trace->call[c] = (struct simulated_call){.trip = 2744, .sequential = 55e-3};
        trace->call[c].execution[WAY_DIRECT] = 36e-3;
    }
    const int parallel = simulate(trace).parallel, first = trace->count - parallel;
    trace->call[first].execution[WAY_DIRECT] = 47e-3;
    assert_int_equal(simulate(trace).parallel, parallel);
    trace->call[first].execution[WAY_DIRECT] = 62e-3;
    assert_int_equal(simulate(trace).parallel, parallel);
    trace->call[first].execution[WAY_DIRECT] = 72e-3;
    assert_in_range(simulate(trace).parallel, 5, parallel - 5);
    free(trace);
}

/* Returns a loop over pairs, while other processes run: 2.8 ms, or 1.9 ms in tiles with two
 * threads, each of which may lose its core for some milliseconds. This happens in a fraction
 * `often` of the executions, and in one of three in calls `begin` to `end`. It happens half as
 * often to the sequential loop. Binning is slower. */
static struct trace *stopped_at_times(uint64_t seed, double often, int begin, int end) {
    struct trace *trace = light(800);
    random_state = seed * 0x9e3779b97f4a7c15u;
    trace->possible[WAY_INDEX] = false;
    trace->possible[WAY_DIRECT] = trace->possible[WAY_BINS] = trace->guessed = true;
    trace->look = 0.45e-3;
    trace->late = 5e-3 * uniform();
    trace->execution_error = 0.85;
    for (int c = 0; c < trace->count; c++) {
        struct simulated_call *call = &trace->call[c];
        const double now = c >= begin && c < end ? 1.0 / 3 : often;
        const double stop = uniform() < now && c > 6 ? 1e-3 + 7e-3 * uniform() : 0;
        call->sequential = 2.8e-3 + (uniform() < now / 2 ? 4e-3 : 0);
        call->execution[WAY_DIRECT] = 1.9e-3 * (0.97 + 0.06 * uniform()) + stop;
        call->execution[WAY_BINS] = 4.4e-3 + stop;
    }
    return trace;
}

static void stops_say_nothing_of_a_plan(void **unused) {
    (void)unused;
    static const struct {
        double often;
        int begin, end;
        double mean, worst; /* total time divided by that of the best strategy */
    } asked[] = {{0, 0, 0, 1.02, 1.02},
                 {0.02, 0, 0, 1.02, 1.05},
                 {0.1, 0, 0, 1.04, 1.1},
                 {0.02, 200, 400, 1.03, 1.2},
                 {0.02, 0, 200, 1.04, 1.1}};
    const unsigned draws = 100;
    for (size_t i = 0; i < sizeof asked / sizeof *asked; i++) {
        double sum = 0, worst = 0;
        for (unsigned seed = 1; seed <= draws; seed++) {
            struct trace *trace =
                stopped_at_times(seed, asked[i].often, asked[i].begin, asked[i].end);
            const struct simulated it = simulate(trace);
            sum += it.total / it.best;
            worst = fmax(worst, it.total / it.best);
            free(trace);
        }
        if (getenv("CHOOSE_SHOW"))
            printf("stopped, %g, %d to %d: total/best %.3f at most, %.3f on average\n",
                   asked[i].often, asked[i].begin, asked[i].end, worst, sum / draws);
        assert_true(sum / draws <= asked[i].mean && worst <= asked[i].worst);
    }
}

/* Iterations are too heavy for an inspection, so binning is tried first and gains a fifth. The
 * gains pay for a sample, which finds a faster plan if there is one. A sample with a long dry run
 * ends at a separate deadline. A sample that a guard ends is not repeated. */
static void bins_are_not_the_end(void **unused) {
    (void)unused;
    static const struct {
        double by_bins, dry_run, wanted;
        bool refused;
    } asked[] = {{32e-3, 0, 0.56, false},
                 {32e-3, 0.1, 0.57, false},
                 {32e-3, 10, 0.79, false},
                 {8e-3, 1000, 0.23, false},
                 {32e-3, 0, 0.82, true}};
    for (size_t i = 0; i < sizeof asked / sizeof *asked; i++) {
        struct trace *trace = light(400);
        trace->possible[WAY_BINS] = trace->guessed = true;
        trace->set_up[WAY_INDEX] = 2e-7;
        trace->dry_run = asked[i].dry_run * 2e-6;
        trace->no_inspection = asked[i].refused;
        for (int c = 0; c < trace->count; c++) {
            trace->call[c] = (struct simulated_call){.trip = 20000, .sequential = 40e-3};
            trace->call[c].execution[WAY_BINS] = asked[i].by_bins;
            trace->call[c].execution[WAY_INDEX] = 21e-3;
        }
        const struct simulated it = simulate(trace);
        assert_true(it.total < asked[i].wanted * it.sequential);
        assert_true(it.slowest <= 1 + share);
        assert_int_equal(it.looks, asked[i].refused);
        trace->count = 6; /* too few calls to repay an execution without binning */
        assert_int_equal(simulate(trace).parallel, 4);
        free(trace);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(light_loops),
        cmocka_unit_test(a_loop_that_becomes_faster),
        cmocka_unit_test(short_loops),
        cmocka_unit_test(little_is_asked),
        cmocka_unit_test(threads_are_lent_for_a_look),
        cmocka_unit_test(threads_that_start_late_for_a_light_loop),
        cmocka_unit_test(a_plan_that_repays),
        cmocka_unit_test(a_first_execution_that_is_slow),
        cmocka_unit_test(stops_say_nothing_of_a_plan),
        cmocka_unit_test(bins_are_not_the_end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
