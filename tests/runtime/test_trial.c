/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A trial of variants within one execution. The execution is cut into parts, and the variant
 * changes from part to part. Every iteration must be executed once, in the loop's order for each
 * element:
 *
 *     for (t = 0; t < trip; t++) { b[row[t]] = b[row[t]] * 0.5 + t; b[other[t]] += t; } */
#include "loop.h"

#include <omp.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { TRIP = 120000, ROWS = 200000, MOST_THREADS = 7, ORDERS = 3 };

static int row[TRIP], other[TRIP];
static double b[ROWS], expected[ROWS];

static const redcc_array arrays[] = {{"b", REDCC_SUM, REDCC_DOUBLE, 8, 8, 0}};
static const redcc_source sources[] = {{"row", 1}, {"other", 1}};
static redcc_loop loop = {.file = "test_trial.c",
                          .line = 1,
                          .function = "both",
                          .order = REDCC_ORDER_SERIAL,
                          .flags = REDCC_VERIFIABLE | REDCC_PREFETCHES | 2 * REDCC_LANES_UNIT |
                                   REDCC_LANES_ANYWHERE,
                          .array_count = 1,
                          .arrays = arrays,
                          .source_count = 2,
                          .sources = sources};

/* The number of iterations handed out by each variant, and the number of changes of variant. */
static long iterations[VARIANTS], changes;

static void tell_all(redcc_worker *worker) {
    for (redcc_int t = worker->first; t < worker->last; t += worker->stride) {
        redcc_touch(worker, 0, &b[row[t]], sizeof *b);
        redcc_touch(worker, 0, &b[other[t]], sizeof *b);
        redcc_iteration_done(worker);
    }
}

static void execute_run(const redcc_worker *worker, redcc_iterations run) {
    const redcc_int begin = worker->origin + run.begin;
    const int checked = run.count_and_check & 1;
    const redcc_owner *owner = &worker->owner[0];
    for (redcc_int t = begin; t < begin + run.count_and_check / 2; t++) {
        double *const first = &b[row[t]], *const second = &b[other[t]];
        if (!checked || redcc_owns(owner, first))
            *first = *first * 0.5 + (double)t;
        if (!checked || redcc_owns(owner, second))
            *second += (double)t;
    }
}

static void execute_all(redcc_worker *worker) {
    int before = -1;
    while (redcc_next(worker)) {
        const int variant = worker->variant.prefetches != 0;
        long count = 0;
        for (const redcc_iterations *run = worker->run; run != worker->run_end; run++) {
            execute_run(worker, *run);
            count += run->count_and_check / 2;
        }
        __atomic_fetch_add(&iterations[variant], count, __ATOMIC_RELAXED);
        __atomic_fetch_add(&changes, before >= 0 && before != variant, __ATOMIC_RELAXED);
        before = variant;
    }
}

static void execute(int threads) {
    void *const bases[] = {b};
    const redcc_extent known[] = {{(const char *)row, (const char *)(row + TRIP)},
                                  {(const char *)other, (const char *)(other + TRIP)}};
    redcc_call call;
    memset(iterations, 0, sizeof iterations);
    changes = 0;
    assert_int_equal(redcc_enter(&call, &loop, TRIP, bases, known, NULL, threads, 0), 1);
#pragma omp parallel num_threads(call.threads)
    {
        redcc_worker worker;
        redcc_join(&worker, &call, omp_get_thread_num(), omp_get_num_threads());
        while (redcc_inspect(&worker))
            tell_all(&worker);
        execute_all(&worker);
    }
    assert_int_equal(redcc_end(&call), 1);
    for (redcc_int t = 0; t < TRIP; t++) {
        expected[row[t]] = expected[row[t]] * 0.5 + (double)t;
        expected[other[t]] += (double)t;
    }
    assert_memory_equal(b, expected, sizeof b);
}

/* Draws subscripts at large and small distances, in short and in long runs. */
static void draw(int order) {
    for (int t = 0; t < TRIP; t++) {
        row[t] = order == 0 ? rand() % ROWS : (int)((long)t * (ROWS - 8) / TRIP);
        other[t] = order == 2 ? row[t] + rand() % 8 : order == 1 ? rand() % ROWS : row[t];
    }
    row[0] = 0;
    other[TRIP - 1] = ROWS - 1; /* more than a megabyte, so that prefetches may help */
}

static void one_execution_is_a_trial(void **unused) {
    (void)unused;
    const int counts[] = {1, 2, 3, MOST_THREADS};
    for (int order = 0; order < ORDERS; order++)
        for (int c = 0; c < 4; c++) {
            draw(order);
            redcc_loop_forget(&loop);
            execute(counts[c]);
            for (unsigned variant = 0; variant < VARIANTS; variant++)
                assert_true(iterations[variant] >= TRIP / VARIANTS / 2 / MOST_THREADS);
            /* with stealing one thread may have executed nearly all parts */
            assert_in_range(changes, VARIANT_PARTS - 1, counts[c] * (VARIANT_PARTS - 1));
            execute(counts[c]);
            int taken = 0;
            for (unsigned variant = 0; variant < VARIANTS; variant++)
                taken += iterations[variant] > 0;
            assert_int_equal(taken, 1);
        }
    redcc_loop_forget(&loop);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(one_execution_is_a_trial)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
