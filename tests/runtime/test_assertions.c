/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Builds with assertions stop if a schedule violates what its method promises. Each method's
 * prepare is replaced by one that makes the method's schedule for this loop and then changes it:
 *
 *     for (t = 0; t < TRIP; t++) b[row[t]] += t;    row[t] = t
 *
 * A correct schedule does not stop the program. The last test has a plan in which every iteration
 * must be executed, although every third touches nothing; the others touch two rows. */
#include "loop.h"
#include "settings.h"

#include <omp.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

enum { TRIP = 6000, THREADS = 2 };

enum { NO_ROW = -1 };

static int row[TRIP], other[TRIP]; /* NO_ROW if the iteration has no such row */
static double b[TRIP];

static const redcc_array array = {"b", REDCC_SUM, REDCC_DOUBLE, 8, 8, 0};
static const redcc_source source = {"row", 1};
static redcc_loop loop = {.file = "test_assertions.c",
                          .line = 5,
                          .function = "execute",
                          .order = REDCC_ORDER_SERIAL,
                          .flags = REDCC_VERIFIABLE,
                          .array_count = 1,
                          .arrays = &array,
                          .source_count = 1,
                          .sources = &source};

static void add(redcc_worker *worker, int to, redcc_int t, bool checked) {
    double *const base = worker->base[0];
    if (to != NO_ROW && (!checked || redcc_owns(&worker->owner[0], &base[to])))
        base[to] += (double)t;
}

static void execute(void) {
    const redcc_extent known[] = {{(const char *)row, (const char *)(row + TRIP)}};
    void *bases[] = {b};
    redcc_call call;
    assert_int_equal(redcc_enter(&call, &loop, TRIP, bases, known, NULL, THREADS, 0), 1);
#pragma omp parallel num_threads(call.threads)
    {
        redcc_worker worker;
        redcc_join(&worker, &call, omp_get_thread_num(), omp_get_num_threads());
        while (redcc_inspect(&worker))
            for (redcc_int t = worker.first; t < worker.last; t += worker.stride) {
                if (row[t] != NO_ROW)
                    redcc_touch(&worker, 0, &b[row[t]], sizeof b[0]);
                if (other[t] != NO_ROW)
                    redcc_touch(&worker, 0, &b[other[t]], sizeof b[0]);
                redcc_iteration_done(&worker);
            }
        while (redcc_next(&worker))
            for (const redcc_iterations *run = worker.run; run < worker.run_end; run++)
                for (redcc_u32 i = 0; i < run->count_and_check / 2; i++) {
                    const redcc_int t = worker.origin + run->begin + i;
                    add(&worker, row[t], t, run->count_and_check & 1);
                    add(&worker, other[t], t, run->count_and_check & 1);
                }
    }
    assert_int_equal(redcc_leave(&call), 1);
}

/* ---- changed schedules ----------------------------------------------------------------------- */

enum change { AS_MADE, COPIED, DROPPED, DOUBLED, SWAPPED };

static const struct method *original;
static enum change change;

/* Copies iteration t of the thread's correct schedule to the changed one. */
static void copy_iteration(struct schedule *to, uint32_t stage, redcc_int t, int thread) {
    const redcc_int changed = TRIP / THREADS * thread + 10;
    if (change == DROPPED && thread == 1 && t == changed)
        return;
    if (change == SWAPPED && t == (thread == 0 ? 0 : TRIP - 1))
        return;
    assert_true(redcc_schedule_add(to, stage, t, 1, false));
    if (change == DOUBLED && thread == 1 && t == changed)
        assert_true(redcc_schedule_add(to, stage, t, 1, false));
}

/* Moves the first iteration from the first thread to the second, and the last one back. */
static bool prepare(struct plan *plan, const struct evidence *evidence, int thread) {
    struct schedule *schedule = &plan->schedule[redcc_own_schedule(plan, thread)];
    if (!original->prepare(plan, evidence, thread))
        return false;
    if (change == AS_MADE)
        return true;
    struct schedule good = *schedule;
    *schedule = (struct schedule){0};
    if (change == SWAPPED && thread == 1)
        assert_true(redcc_schedule_add(schedule, 0, 0, 1, false));
    for (size_t c = 0; c < good.chunk_count; c++) {
        struct run_reader runs = redcc_runs_of(&good, &good.chunk[c]);
        for (redcc_iterations run; redcc_runs_read(&runs, &run, 1) == 1;)
            for (redcc_u32 i = 0; i < run.count_and_check / 2; i++)
                copy_iteration(schedule, good.chunk[c].stage, good.chunk[c].origin + run.begin + i,
                               thread);
    }
    if (change == SWAPPED && thread == 0)
        assert_true(redcc_schedule_add(schedule, 0, TRIP - 1, 1, false));
    redcc_schedule_end(&good);
    return true;
}

/* Does the loop, executed in a child process, end without a failed assertion? */
static bool survives(const struct method *method, enum change to_make) {
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        const struct rlimit no_core = {0, 0};
        struct method mutant = *method;
        setrlimit(RLIMIT_CORE, &no_core);
        if (!freopen("/dev/null", "w", stderr))
            _exit(3);
        mutant.prepare = prepare;
        original = method;
        change = to_make;
        struct settings *settings = (struct settings *)(uintptr_t)redcc_settings();
        settings->method = &mutant;
        settings->parameter = method->usual;
        execute();
        _exit(0);
    }
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    if (WIFSIGNALED(status))
        assert_int_equal(WTERMSIG(status), SIGABRT);
    else
        assert_int_equal(status, 0);
    return !WIFSIGNALED(status);
}

static void a_changed_schedule_trips_an_assertion(void **unused) {
    (void)unused;
    static const struct method *const methods[] = {
        &redcc_method_localwrite, &redcc_method_localwrite_steal, &redcc_method_graph_localwrite,
        &redcc_method_wavefront,  &redcc_method_expansion,        &redcc_method_pseudo_expansion,
        &redcc_method_dwa_lip};
    for (size_t m = 0; m < sizeof methods / sizeof *methods; m++) {
        assert_true(survives(methods[m], COPIED));
#ifdef NDEBUG
        const bool watched = false;
#else
        const bool watched = true;
#endif
        assert_int_equal(survives(methods[m], DROPPED), !watched);
        assert_int_equal(survives(methods[m], DOUBLED), !watched);
        if (methods[m]->keeps == REDCC_ORDER_SERIAL) /* in other orders a swap is allowed */
            assert_int_equal(survives(methods[m], SWAPPED), !watched);
    }
}

static void a_plan_that_checks_what_touches_nothing_is_right(void **unused) {
    (void)unused;
    loop.flags = REDCC_VERIFIABLE | REDCC_EVERY_ITERATION;
    for (int t = 0; t < TRIP; t++) {
        row[t] = t % 3 ? t : NO_ROW;
        other[t] = t % 3 ? TRIP - 1 - t : NO_ROW;
    }
    assert_true(survives(&redcc_method_localwrite, AS_MADE));
}

int main(void) {
    for (int t = 0; t < TRIP; t++) {
        row[t] = t;
        other[t] = NO_ROW;
    }
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_changed_schedule_trips_an_assertion),
        cmocka_unit_test(a_plan_that_checks_what_touches_nothing_is_right)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
