/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The bounds of docs/choosing.md, on families of simulated loops. */
#include "choose_traces.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* The largest overdraft, in sequential executions, if a timing is up to 30 % too high. */
static const double overdraft_most = 1.25 * 1.3 / 0.7;

static double between(double low, double high) {
    return low + (high - low) * uniform();
}

/* The bounds that a test requires of a trace. */
struct asked {
    double sequential; /* largest ratio, over all prefixes, of the time less the allowance to the
                          sequential time */
    double best; /* largest ratio of the total time to that of the best strategy in hindsight */
    int set_ups; /* maximum number of plan constructions, or 0 without a limit */
};

static void check(struct trace *trace, const char *name, struct asked asked) {
    const struct simulated it = simulate(trace);
    if (getenv("CHOOSE_SHOW"))
        printf(
            "%-34s prefix %.4f  total/sequential %.4f  total/best %.4f  set-ups %d  parallel %d\n",
            name, it.worst_prefix, it.total / it.sequential, it.total / it.best, it.set_ups,
            it.parallel);
    if (it.overdraft > overdraft_most)
        fail_msg("%s: an overdraft of %.4f executions", name, it.overdraft);
    if (it.worst_prefix > asked.sequential)
        fail_msg("%s: %.4f times the sequential program's time", name, it.worst_prefix);
    if (asked.set_ups && it.set_ups > asked.set_ups)
        fail_msg("%s: %d set-ups", name, it.set_ups);
    if (it.total > asked.best * it.best)
        fail_msg("%s: %.4f times the best way's time", name, it.total / it.best);
    free(trace);
}

static void stable_loops(void **unused) {
    (void)unused;
    check(ordinary(1), "once", (struct asked){1, 1, 0});
    check(ordinary(3), "thrice", (struct asked){1, 1.5, 0});
    check(ordinary(10), "10", (struct asked){1 + share, 1.6, 1});
    check(ordinary(40), "40", (struct asked){1 + share, 1.33, 2});
    check(ordinary(400), "400", (struct asked){1 + share, 1.05, 2});
    check(ordinary(2000), "2000", (struct asked){1 + share, 1.03, 2});
}

/* Returns a loop of 100 ms with long iterations and one strategy. set_up: time of its plan
 * construction, in executions. */
static struct trace *heavy(int count, double set_up, double faster) {
    struct trace *trace = ordinary(count);
    const double sequential = 100e-3;
    trace->possible[WAY_GRAPH] = false;
    trace->set_up[WAY_INDEX] = set_up * sequential * 1e-6;
    trace->check = 0.01;
    trace->compared = true;
    for (int c = 0; c < count; c++) {
        trace->call[c].sequential = sequential;
        trace->call[c].execution[WAY_INDEX] = sequential / faster;
    }
    return trace;
}

/* Checks that the program is at least `wanted` times as fast as the sequential one. */
static void check_gain(struct trace *trace, const char *name, double wanted) {
    const struct simulated it = simulate(trace);
    if (it.sequential / it.total < wanted)
        fail_msg("%s: %.3f times as fast, not %.2f", name, it.sequential / it.total, wanted);
    if (trace->count >= 10 && it.owed > 0)
        fail_msg("%s: %g seconds are still lent", name, it.owed);
    check(trace, name, (struct asked){1 + share, 2, 1});
}

static void heavy_loops(void **unused) {
    (void)unused;
    struct trace *trace = heavy(10, 0.03, 1.95);
    trace->compared = false;
    check_gain(trace, "heavy, 10, cheap set-up", 1.6);
    check_gain(heavy(40, 0.03, 1.95), "heavy, 40, cheap set-up", 1.8);
    check_gain(heavy(10, 0.6, 1.74), "heavy, 10, set-up of 0.6", 1.3);
    check_gain(heavy(40, 0.6, 1.74), "heavy, 40, set-up of 0.6", 1.6);
    check_gain(heavy(3, 0.6, 1.74), "heavy, 3, set-up of 0.6", 1);
    check_gain(heavy(1, 0.6, 1.74), "heavy, once", 1);
    trace = heavy(40, 1, 1.74);
    trace->compared = false; /* so that an overdraft is allowed only if little can be lost */
    check(trace, "heavy, 40, not compared", (struct asked){1 + share, 1.35, 1});
}

/* Returns the number of parallel executions of a loop whose first execution takes `first` times as
 * long as the others. */
static int parallel_executions(int count, double first, double faster) {
    struct trace *trace = heavy(count, 0.03, faster);
    trace->call[0].sequential *= first;
    const struct simulated it = simulate(trace);
    if (it.total > (1 + share) * it.sequential)
        fail_msg("first %g, %g times as fast: %.4f times the sequential program's time", first,
                 faster, it.total / it.sequential);
    free(trace);
    return it.parallel;
}

/* The sequential loop is timed a second time: the later, the clearer the plan is faster. */
static void first_executions_take_longer(void **unused) {
    (void)unused;
    assert_int_equal(parallel_executions(40, 1.5, 1.9), 38);
    assert_int_equal(parallel_executions(100, 1.5, 1.9), 97);
    assert_int_equal(parallel_executions(40, 1.5, 1.4), 38);
    assert_in_range(parallel_executions(400, 1.5, 0.9), 1, 30); /* the plan was slower */
    assert_in_range(parallel_executions(400, 3, 0.9), 1, 80);
}

/* Returns a loop of 100 ms: random updates of a large array, with other subscripts in each call, by
 * binning. */
static struct trace *in_bins(int count, double execution) {
    struct trace *trace = heavy(count, 0.5, 1);
    trace->compared = false;
    trace->possible[WAY_INDEX] = false;
    trace->possible[WAY_BINS] = true;
    trace->execution_error = 0.55 / execution;
    for (int c = 0; c < count; c++) {
        trace->call[c].subscripts = c;
        trace->call[c].execution[WAY_BINS] = execution * trace->call[c].sequential;
    }
    return trace;
}

/* If the time of binning is not estimated, it is tried only if no plan is possible. */
static void bins_without_an_estimate(void **unused) {
    (void)unused;
    struct trace *trace = in_bins(10, 0.6);
    trace->guessed = true;
    check_gain(trace, "bins without an estimate", 1.35);
    trace = heavy(10, 0.03, 1.9);
    const double without = simulate(trace).total;
    trace->possible[WAY_BINS] = trace->guessed = true;
    for (int c = 0; c < trace->count; c++)
        trace->call[c].execution[WAY_BINS] = 1.6 * trace->call[c].sequential;
    const struct simulated it = simulate(trace);
    assert_int_equal(it.left, 0);
    assert_true(it.total <= without);
    free(trace);
}

/* Binning is faster in the first 100 calls. From then on a guard ends it in each call, after some
 * time has been lost. */
static void bins_that_are_refused(void **unused) {
    (void)unused;
    struct trace *trace = in_bins(400, 0.5);
    trace->refused_from = 100;
    trace->refusal = 30e-3;
    assert_in_range(simulate(trace).refused, 1, 6);
    check(trace, "bins, refused from the 100th call on", (struct asked){1 + share, 2, 0});
}

/* Iteration times differ from call to call: a trial compares parts of one execution. */
static void bins_of_uneven_calls(void **unused) {
    (void)unused;
    struct trace *trace = in_bins(12, 0.7);
    for (int c = 0; c < trace->count; c += 2) {
        trace->call[c].sequential *= 2;
        trace->call[c].execution[WAY_BINS] *= 2;
    }
    check_gain(trace, "bins, every other call twice as long", 1.25);
    trace = in_bins(12, 1.5);
    for (int c = 0; c < 2; c++) {
        trace->call[c].sequential *= 2;
        trace->call[c].execution[WAY_BINS] *= 2;
    }
    const struct simulated it = simulate(trace);
    assert_int_equal(it.parallel, 0);
    free(trace);
}

/* Binning needs no plan: it is tried after two sequential executions and a sample. If it is slower,
 * only a part of one execution is lost. */
static void bins_on_trial(void **unused) {
    (void)unused;
    check_gain(in_bins(10, 0.4), "bins, 10", 1.9);
    check_gain(in_bins(40, 0.4), "bins, 40", 2.2);
    check_gain(in_bins(10, 0.7), "bins of little gain, 10", 1.25);
    static const double slower[] = {1.1, 1.5, 2, 3};
    static const int counts[] = {3, 10, 40, 400};
    for (int s = 0; s < 4; s++)
        for (int c = 0; c < 4; c++) {
            struct trace *trace = in_bins(counts[c], slower[s]);
            const struct simulated it = simulate(trace);
            if (getenv("CHOOSE_SHOW"))
                printf("bins, %g times as slow, %d: slowest %.4f\n", slower[s], counts[c],
                       it.slowest);
            if (it.slowest > 1 / 0.95)
                fail_msg("bins, %g times as slow: %.4f times the sequential program's time",
                         slower[s], it.slowest);
            if (counts[c] == 400 && it.total > 1.005 * it.sequential)
                fail_msg("bins, %g times as slow, are tried again too often", slower[s]);
            free(trace);
        }
    struct trace *trace = in_bins(40, 0.4); /* in the first trial another process used a core */
    trace->call[2].execution[WAY_BINS] = 3 * trace->call[2].sequential;
    check_gain(trace, "bins, the first trial slow", 1.9);
    trace = in_bins(3, 1.6); /* the sample leaves less credit than a trial may lose */
    trace->look = 3.2e-3;
    assert_true(simulate(trace).slowest < 1.02);
    free(trace);
}

/* Binning seemed the best strategy but was not. The next best is used, and binning is not tried
 * again. */
static void what_has_failed_is_not_tried_again(void **unused) {
    (void)unused;
    struct trace *trace = heavy(40, 0.3, 1.74);
    trace->compared = false;
    trace->execution_error = 0.2;
    trace->possible[WAY_BINS] = true;
    for (int c = 0; c < trace->count; c++)
        trace->call[c].execution[WAY_BINS] = 2 * trace->call[c].sequential;
    const struct simulated it = simulate(trace);
    assert_int_equal(it.left, 1);
    assert_in_range(it.parallel, 20, 39);
    free(trace);
}

/* A strategy without a plan, which changes of subscripts do not affect, and a slower one. */
static void without_a_set_up(void **unused) {
    (void)unused;
    static const int counts[] = {3, 10, 40, 400};
    for (int c = 0; c < 4; c++)
        for (int slower = 0; slower < 2; slower++) {
            struct trace *trace = heavy(counts[c], 0.5, 1);
            char name[40];
            trace->possible[WAY_INDEX] = false;
            trace->possible[WAY_DIRECT] = true;
            trace->execution_error = slower ? 0.6 / 1.3 : 1;
            for (int k = 0; k < counts[c]; k++) {
                trace->call[k].subscripts = k;
                trace->call[k].execution[WAY_DIRECT] =
                    (slower ? 1.3 : 0.6) * trace->call[k].sequential;
            }
            snprintf(name, sizeof name, "direct%s, %d", slower ? ", slower" : "", counts[c]);
            check(trace, name, (struct asked){1 + share, slower ? 1.12 : 1.55, 0});
        }
}

/* The overdraft is lost once, and not again before a plan construction has paid off. */
static void subscripts_that_change_after_the_first_reuse(void **unused) {
    (void)unused;
    for (int hidden = 0; hidden < 2; hidden++)
        for (int every = 2; every < 6; every++) {
            struct trace *trace = heavy(400, 0.6, 1.74);
            char name[80];
            for (int c = 0; c < trace->count; c++)
                trace->call[c].subscripts = c < 3 ? 0 : 1 + (c - 3) / every;
            trace->hidden = hidden;
            snprintf(name, sizeof name, "changes after the first reuse, then every %d%s", every,
                     hidden ? ", hidden" : "");
            check(trace, name, (struct asked){1 + share, 1.22, 0});
        }
    struct trace *trace = heavy(2000, 0.6, 1.74); /* after that the subscripts never change */
    for (int c = 3; c < trace->count; c++)
        trace->call[c].subscripts = 1;
    check(trace, "changes once, after the first reuse", (struct asked){1 + share, 1.05, 2});
}

static void loops_that_never_gain(void **unused) {
    (void)unused;
    struct trace *trace = ordinary(2000);
    for (int c = 0; c < trace->count; c++)
        scale(&trace->call[c], 1, 2);
    check(trace, "parallel twice as slow", (struct asked){1 + share, 1.001, 1});
    trace = ordinary(2000);
    trace->execution_error = 0.4;
    for (int c = 0; c < trace->count; c++)
        scale(&trace->call[c], 1, 2);
    check(trace, "the same, not expected", (struct asked){1 + share, 1.01, 3});
    trace = ordinary(2000);
    for (int c = 0; c < trace->count; c++)
        scale(&trace->call[c], 1e-2, 1e-2);
    check(trace, "short", (struct asked){1, 2, 1});
}

/* A dry run of unknown length, here `executions` executions, precedes each sample. A dry run that
 * does not end within the credit is stopped. */
static void check_dry_run(double executions, double parallel, double best, int stopped) {
    struct trace *trace = ordinary(2000);
    char name[64];
    trace->dry_run = executions * 10e-9;
    for (int c = 0; c < trace->count; c++)
        scale(&trace->call[c], 1, parallel);
    const struct simulated it = simulate(trace);
    snprintf(name, sizeof name, "dry runs of %.1f executions%s", executions,
             parallel > 1 ? ", no gain" : "");
    if (it.slowest > 1 / 0.95)
        fail_msg("%s: %.4f times the sequential program's time", name, it.slowest);
    assert_int_equal(it.stopped, stopped);
    check(trace, name, (struct asked){1 + share, best, 2});
}

static void dry_runs(void **unused) {
    (void)unused;
    check_dry_run(0.3, 1, 1.06, 0);
    check_dry_run(0.9, 1, 1.06, 0);
    check_dry_run(2, 1, 1.06, 1);
    check_dry_run(5, 1, 1.1, 1);
    check_dry_run(0.3, 2, 1.01, 0);
    check_dry_run(2, 2, 1.01, 1);
    check_dry_run(5, 2, 1.02, 1);
}

/* Springs of a sorted mesh: 4 ms per execution, and twice as much for the first one. A plan
 * construction takes half an execution. Nothing compares the subscripts. */
static void a_light_loop_whose_subscripts_stay(void **unused) {
    (void)unused;
    static const struct {
        int count;
        double wanted;
    } asked[] = {{20, 1.3}, {400, 1.65}};
    for (int i = 0; i < 2; i++) {
        struct trace *trace = ordinary(asked[i].count);
        trace->possible[WAY_GRAPH] = false;
        trace->set_up[WAY_INDEX] = 2e-9;
        trace->set_up_error = 0.6;
        trace->start = 1.5e-3;
        for (int c = 0; c < trace->count; c++) {
            trace->call[c].sequential = c ? 4e-3 : 8e-3;
            trace->call[c].execution[WAY_INDEX] = 2.3e-3;
        }
        check_gain(trace, "light, subscripts stay", asked[i].wanted);
    }
}

/* At first the system has no core for the threads, so a sample takes longer. */
static void threads_that_start_late(void **unused) {
    (void)unused;
    struct trace *trace = heavy(10, 0.06, 1.9);
    trace->start = 1e-3;
    trace->late = 40e-3;
    check_gain(trace, "threads start late", 1.45);
    trace = heavy(10, 0.3, 1.9); /* other programs run during the plan construction */
    trace->set_up_error = 0.2;
    assert_int_equal(simulate(trace).stopped, 0);
    free(trace);
    trace = ordinary(4); /* one thread takes the sample without waiting for others */
    trace->start = 0.1e-3;
    trace->late = 40e-3;
    assert_true(simulate(trace).slowest < 1.02);
    free(trace);
}

/* Before each call two of millions of keys change, which samples miss. */
static void samples_that_mislead(void **unused) {
    (void)unused;
    for (int count = 1; count <= 200; count++) {
        struct trace *trace = heavy(count, 0.85, 1.7);
        trace->compared = false;
        trace->hidden = true;
        trace->check = 0.3;
        for (int c = 0; c < count; c++)
            trace->call[c].subscripts = c;
        const struct simulated it = simulate(trace);
        if (it.slowest > 1.05)
            fail_msg("%d calls: %.4f times the sequential program's time", count, it.slowest);
        free(trace);
    }
}

/* Since estimates are not exact, no plan is constructed for a gain of less than a tenth. */
static void a_gain_that_may_be_none(void **unused) {
    (void)unused;
    struct trace *trace = ordinary(400);
    for (int c = 0; c < trace->count; c++)
        trace->call[c].execution[WAY_INDEX] = trace->call[c].execution[WAY_GRAPH] = 9.2e-3;
    assert_int_equal(simulate(trace).set_ups, 0);
    free(trace);
}

static void noise(void **unused) {
    (void)unused;
    random_state = 88172645463325252u;
    for (int gain = 0; gain < 4; gain++) {
        struct trace *trace = ordinary(2000);
        for (int c = 0; c < trace->count; c++) {
            /* separate statements, so that every compiler draws in this order */
            const double parallel = between(0.7, 1.3) * (1 + 0.3 * gain);
            scale(&trace->call[c], between(0.7, 1.3), parallel);
        }
        static const char *const names[] = {"noise of 30 %", "noise, 1.4 times as fast",
                                            "noise, 1.14 times as fast", "noise, slower"};
        check(trace, names[gain], (struct asked){1 + share, 1.12, 8});
    }
}

/* The same noise with other random numbers must satisfy the same bounds. */
static void noise_of_many_kinds(void **unused) {
    (void)unused;
    for (int gain = 0; gain < 4; gain++) {
        double worst = 0, sum = 0;
        for (unsigned seed = 1; seed <= 100; seed++) {
            struct trace *trace = ordinary(2000);
            random_state = seed * 0x9e3779b97f4a7c15u;
            for (int c = 0; c < trace->count; c++) {
                const double parallel = between(0.7, 1.3) * (1 + 0.3 * gain);
                scale(&trace->call[c], between(0.7, 1.3), parallel);
            }
            const struct simulated it = simulate(trace);
            worst = fmax(worst, it.total / it.best);
            sum += it.total / it.best;
            assert_true(it.worst_prefix <= (1 + share) * 1.06);
            free(trace);
        }
        if (getenv("CHOOSE_SHOW"))
            printf("noise %d, 100 draws: total/best %.4f at most, %.4f on average\n", gain, worst,
                   sum / 100);
        assert_true(worst <= 1.28 && sum / 100 <= 1.085);
    }
}

static void drift(void **unused) {
    (void)unused;
    for (int both = 0; both < 3; both++) {
        struct trace *trace = ordinary(2000);
        for (int c = 0; c < trace->count; c++) {
            const double wave = exp2(sin(c / 50.0)), other = exp2(cos(c / 70.0));
            scale(&trace->call[c], both == 2 ? 1 : wave, both == 0 ? wave : other);
        }
        static const char *const names[] = {"drift of both", "drift of each", "drift of parallel"};
        check(trace, names[both], (struct asked){1 + share, 1.2, 3});
    }
}

/* For a second another program takes a core, so each thread's half takes twice as long. */
static void a_neighbour(void **unused) {
    (void)unused;
    struct trace *trace = ordinary(2000);
    for (int c = 0; c < trace->count; c++)
        if (c % 500 >= 100 && c % 500 < 200)
            scale(&trace->call[c], 1, 2);
    check(trace, "a neighbour for a second", (struct asked){1 + share, 1.04, 3});
    trace = ordinary(2000);
    for (int c = 0; c < trace->count; c++)
        if (c % 100 == 50)
            scale(&trace->call[c], 1, 10);
    check(trace, "stalls", (struct asked){1 + share, 1.15, 3});
}

/* From the 500th call on one of the two strategies becomes slower by this factor. */
static void what_was_faster_no_longer_is(void **unused) {
    (void)unused;
    struct trace *trace = ordinary(2000);
    for (int c = 500; c < trace->count; c++)
        scale(&trace->call[c], 1, 3);
    check(trace, "plans become slow", (struct asked){1 + share, 0.91, 3});
    trace = ordinary(2000);
    for (int c = 500; c < trace->count; c++)
        scale(&trace->call[c], 0.25, 1);
    check(trace, "the sequential loop becomes fast", (struct asked){1 + share, 0.88, 3});
}

/* Returns the number of calls from `begin` on that no plan executes. From call 600 on the
 * subscripts differ (`others`), or the sequential loop is faster for 400 calls (`faster`). */
static int sequential_from(int begin, bool others, bool faster) {
    int parallel[2];
    for (int whole = 0; whole < 2; whole++) {
        struct trace *trace = ordinary(whole ? SIMULATED_CALLS : begin);
        for (int c = 600; c < trace->count; c++) {
            trace->call[c].subscripts = others;
            scale(&trace->call[c], faster && c < 1000 ? 0.25 : 1, 1);
        }
        parallel[whole] = simulate(trace).parallel;
        free(trace);
    }
    return SIMULATED_CALLS - begin - (parallel[1] - parallel[0]);
}

/* The sequential loop is timed after 52 executions by this plan, then after 105, 209 and 419 more.
 * These numbers start again with another plan, and after the sequential loop was faster. */
static void the_sequential_loop_is_timed_again(void **unused) {
    (void)unused;
    assert_int_equal(sequential_from(30, false, false), 3 + 3);
    assert_int_equal(sequential_from(600, false, false), 3);
    assert_int_equal(sequential_from(620, true, false), 3 + 2);
    assert_int_equal(sequential_from(1200, false, true), 3);
}

static void subscripts_that_change(void **unused) {
    (void)unused;
    static const int every[] = {1, 2, 5, 20};
    for (int e = 0; e < 4; e++)
        for (int hidden = 0; hidden < 2; hidden++)
            for (int costly = 0; costly < 2; costly++) {
                struct trace *trace = ordinary(2000);
                char name[80];
                for (int c = 0; c < trace->count; c++)
                    trace->call[c].subscripts = c / every[e];
                trace->hidden = hidden;
                if (costly)
                    trace->set_up[WAY_INDEX] = trace->set_up[WAY_GRAPH] = 100e-9;
                snprintf(name, sizeof name, "changes every %d%s%s", every[e],
                         hidden ? ", hidden" : "", costly ? ", expensive" : "");
                check(trace, name,
                      (struct asked){1 + share,
                                     costly           ? 1.03
                                     : every[e] == 20 ? 1.1
                                                      : 1.2,
                                     costly || every[e] == 1 ? hidden ? 8 : 4 : 0});
            }
}

static void sizes_that_alternate(void **unused) {
    (void)unused;
    struct trace *trace = ordinary(2000);
    for (int c = 0; c < trace->count; c++)
        if (c % 2) {
            trace->call[c].trip = 1000;
            scale(&trace->call[c], 1e-3, 1e-2);
        }
    check(trace, "sizes alternate", (struct asked){1 + share, 0.6, 3});
    trace = ordinary(2000);
    for (int c = 0; c < trace->count; c++) {
        const double size = (double)(1 << c % 8);
        trace->call[c].trip = (long long)(1e5 * size);
        scale(&trace->call[c], size / 10, size / 10);
    }
    check(trace, "eight sizes in turn", (struct asked){1 + share, 0.95, 0});
}

static void estimates_that_are_wrong(void **unused) {
    (void)unused;
    static const double errors[] = {0.1, 10};
    for (int e = 0; e < 2; e++)
        for (int costly = 0; costly < 2; costly++) {
            struct trace *trace = ordinary(2000);
            char name[80];
            trace->set_up_error = errors[e];
            if (costly)
                trace->set_up[WAY_INDEX] = trace->set_up[WAY_GRAPH] = 200e-9;
            snprintf(name, sizeof name, "set-ups estimated at %g%s", errors[e],
                     costly ? ", expensive" : "");
            check(trace, name, (struct asked){1 + share, !costly ? 1.1 : e ? 1.8 : 1.45, 5});
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stable_loops),
        cmocka_unit_test(heavy_loops),
        cmocka_unit_test(first_executions_take_longer),
        cmocka_unit_test(bins_on_trial),
        cmocka_unit_test(bins_without_an_estimate),
        cmocka_unit_test(bins_that_are_refused),
        cmocka_unit_test(bins_of_uneven_calls),
        cmocka_unit_test(without_a_set_up),
        cmocka_unit_test(what_has_failed_is_not_tried_again),
        cmocka_unit_test(subscripts_that_change_after_the_first_reuse),
        cmocka_unit_test(loops_that_never_gain),
        cmocka_unit_test(dry_runs),
        cmocka_unit_test(a_light_loop_whose_subscripts_stay),
        cmocka_unit_test(threads_that_start_late),
        cmocka_unit_test(samples_that_mislead),
        cmocka_unit_test(a_gain_that_may_be_none),
        cmocka_unit_test(noise),
        cmocka_unit_test(noise_of_many_kinds),
        cmocka_unit_test(drift),
        cmocka_unit_test(a_neighbour),
        cmocka_unit_test(what_was_faster_no_longer_is),
        cmocka_unit_test(the_sequential_loop_is_timed_again),
        cmocka_unit_test(subscripts_that_change),
        cmocka_unit_test(sizes_that_alternate),
        cmocka_unit_test(estimates_that_are_wrong),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
