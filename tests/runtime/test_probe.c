/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Iterations that are probed instead of recorded (redcc_is_settled): the plan must be the same as
 * if all were recorded. The loop is not executed:
 *
 *     for (t = 0; t < trip; t++)
 *         if (wide[t]) { b[row[t]] ... b[row[t] + wide[t] - 1] are updated, d[other[t]] too, and
 *                        x[read[t]] is read } */
#include "loop.h"

#include <omp.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { TRIP = 6000, ROWS = 2000, MIDDLE = 700, WIDEST = 8, MOST_THREADS = 7 };

static int row[TRIP], other[TRIP], wide[TRIP], read_at[TRIP];
static double b[ROWS + WIDEST][3], d[ROWS], x[ROWS];
static long probed; /* iterations that were not recorded */

static const redcc_array arrays[] = {{"b", REDCC_SUM, REDCC_DOUBLE, 8, sizeof b[0], 0},
                                     {"d", REDCC_SUM, REDCC_DOUBLE, 8, 8, 0}};
static const redcc_source sources[] = {{"row", 1}, {"x", 0}};
#define LOOP                                                                                       \
    { "test_probe.c", 1, "plan", REDCC_ORDER_SERIAL, REDCC_VERIFIABLE, 2, arrays, 2, sources, 0, 0 }
static redcc_loop loop_told = LOOP, loop_probed = LOOP;

/* True if rows are recorded by their numbers, which may be negative. */
static bool by_number;
static double (*const middle)[3] = b + MIDDLE;

static void tell(redcc_worker *worker, redcc_int t) {
    if (!wide[t])
        return;
    redcc_read(worker, 1, &x[read_at[t]], sizeof *x);
    redcc_touch(worker, 0, &b[row[t]], sizeof b[0] * (redcc_size)wide[t]);
    redcc_touch(worker, 1, &d[other[t]], sizeof *d);
}

static void look_at(redcc_probe *probe, const redcc_worker *worker, redcc_int t) {
    if (!wide[t])
        return;
    if (by_number) {
        redcc_probe_read_row(probe, worker, 1, x, read_at[t], sizeof *x);
        redcc_probe_touch_row(probe, worker, 1, d, other[t], sizeof *d);
    } else {
        redcc_probe_read(probe, worker, 1, &x[read_at[t]], sizeof *x);
        redcc_probe_touch(probe, worker, 1, &d[other[t]], sizeof *d);
    }
    if (by_number && wide[t] == 1)
        redcc_probe_touch_row(probe, worker, 0, middle, row[t] - MIDDLE, sizeof b[0]);
    else
        redcc_probe_touch(probe, worker, 0, &b[row[t]], sizeof b[0] * (redcc_size)wide[t]);
}

static void tell_all(redcc_worker *worker) {
    for (redcc_int t = worker->first; t < worker->last; t += worker->stride) {
        tell(worker, t);
        redcc_iteration_done(worker);
    }
}

static void probe_and_tell(redcc_worker *worker) {
    for (redcc_int t = worker->first; t < worker->last; t += worker->stride) {
        if (redcc_is_settled(worker)) {
            const redcc_int from = t;
            for (; t < worker->last; t++) {
                redcc_probe probe = {0, 0, 0, 0, 0, 0, 0, 0};
                look_at(&probe, worker, t);
                if (!redcc_is_alike(&probe))
                    break;
            }
            worker->alike += t - from;
            __atomic_fetch_add(&probed, t - from, __ATOMIC_RELAXED);
            if (t == worker->last)
                break;
        }
        tell(worker, t);
        redcc_iteration_done(worker);
    }
}

static const struct kept_plan *plan_of(redcc_loop *loop, void (*inspect)(redcc_worker *),
                                       int threads) {
    void *const bases[] = {middle, d};
    const redcc_extent known[] = {{(const char *)row, (const char *)(row + TRIP)},
                                  {(const char *)x, 0}};
    redcc_call call;
    redcc_loop_forget(loop);
    assert_true(redcc_enter(&call, loop, TRIP, bases, known, 0, threads, 0));
#pragma omp parallel num_threads(call.threads)
    {
        redcc_worker worker;
        redcc_join(&worker, &call, omp_get_thread_num(), omp_get_num_threads());
        while (redcc_inspect(&worker))
            inspect(&worker);
        while (redcc_next(&worker))
            continue;
    }
    assert_true(redcc_leave(&call));
    const struct loop_state *state = loop->state;
    assert_non_null(state->cache.kept[0]);
    return state->cache.kept[0];
}

static void expect_same_schedule(const struct schedule *one, const struct schedule *two) {
    assert_int_equal(one->iterations, two->iterations);
    assert_int_equal(one->chunk_count, two->chunk_count);
    for (size_t c = 0; c < one->chunk_count; c++) {
        struct run_reader mine = redcc_runs_of(one, &one->chunk[c]);
        struct run_reader its = redcc_runs_of(two, &two->chunk[c]);
        assert_int_equal(one->chunk[c].origin, two->chunk[c].origin);
        redcc_iterations run, same;
        while (redcc_runs_read(&mine, &run, 1)) {
            assert_int_equal(redcc_runs_read(&its, &same, 1), 1);
            assert_int_equal(run.begin, same.begin);
            assert_int_equal(run.count_and_check, same.count_and_check);
        }
        assert_int_equal(redcc_runs_read(&its, &same, 1), 0);
    }
}

/* Compares the plans made with and without probing. Returns the number of iterations that were not
 * recorded. */
static long expect_same_plans(void) {
    probed = 0;
    by_number = !by_number;
    for (int threads = 2; threads <= MOST_THREADS; threads++) {
        const struct kept_plan *kept_told = plan_of(&loop_told, tell_all, threads);
        const struct kept_plan *kept = plan_of(&loop_probed, probe_and_tell, threads);
        const struct plan *told = kept_told->plan, *plan = kept->plan;
        const size_t bounds = 2 * (size_t)(told->owners + 1);
        assert_int_equal(told->owners, plan->owners);
        assert_memory_equal(told->bound, plan->bound, bounds * sizeof *told->bound);
        assert_memory_equal(told->touched, plan->touched, 2 * sizeof *told->touched);
        assert_int_equal(kept_told->source[1].extent.first, kept->source[1].extent.first);
        assert_int_equal(kept_told->source[1].extent.end, kept->source[1].extent.end);
        for (int thread = 0; thread < threads; thread++)
            expect_same_schedule(&told->schedule[thread], &plan->schedule[thread]);
    }
    redcc_loop_forget(&loop_told);
    redcc_loop_forget(&loop_probed);
    return probed;
}

static unsigned long random_state = 5;

static int below(int limit) {
    random_state = random_state * 6364136223846793005u + 1442695040888963407u;
    return (int)((random_state >> 33) % (unsigned long)limit);
}

/* Fills in ascending rows: each iteration touches one of the next `near` rows. */
static void fill_in_order(int near) {
    for (int t = 0; t < TRIP; t++) {
        row[t] = (int)((long)t * (ROWS - near) / TRIP) + below(near);
        other[t] = read_at[t] = row[t];
        wide[t] = 1;
    }
}

static void rows_in_order(void **unused) {
    (void)unused;
    fill_in_order(9);
    assert_true(expect_same_plans() > TRIP * (MOST_THREADS - 1) / 2);
    assert_true(expect_same_plans() > TRIP * (MOST_THREADS - 1) / 2);
    for (int t = 0; t < TRIP; t++)
        row[t] = ROWS - 1 - row[t];
    expect_same_plans();
    expect_same_plans();
}

static void rows_without_order(void **unused) {
    (void)unused;
    fill_in_order(ROWS - 1);
    assert_true(expect_same_plans() < TRIP * (MOST_THREADS - 1) / 10);
}

/* A single iteration in a settled stretch touches or reads elsewhere, which must be found. */
static void strays(void **unused) {
    (void)unused;
    for (int trial = 0; trial < 49; trial++) {
        fill_in_order(5);
        for (int t = 0; t < TRIP; t++)
            row[t] = other[t] = read_at[t] = 100 + row[t] * (ROWS - 200) / ROWS;
        const int where[] = {0, 99, ROWS - 1, below(ROWS)};
        int *const changed[] = {row, other, read_at};
        changed[trial % 3][below(TRIP)] = where[trial % 4];
        expect_same_plans();
    }
}

static void idle_iterations(void **unused) {
    (void)unused;
    for (int trial = 0; trial < 8; trial++) {
        fill_in_order(5);
        for (int t = 0; t < TRIP; t++)
            wide[t] = below(trial < 4 ? 50 : 3) > 0;
        expect_same_plans();
    }
}

/* Touches that lie on both sides of a cut or of the range seen so far, or begin before that
 * range. */
static void wide_touches(void **unused) {
    (void)unused;
    for (int trial = 0; trial < 8; trial++) {
        fill_in_order(3);
        for (int t = 0; t < TRIP; t++)
            wide[t] = below(20) ? 1 : 1 + below(WIDEST);
        expect_same_plans();
    }
}

/* Owners alternate after stretches of any length. */
static void stretches(void **unused) {
    (void)unused;
    for (int trial = 0; trial < 8; trial++) {
        fill_in_order(1);
        for (int t = 0, place = 0, left = 0; t < TRIP; t++, left--) {
            if (left == 0) {
                left = 1 + below(4 * REDCC_SETTLED);
                place = below(ROWS - 50);
            }
            row[t] = other[t] = read_at[t] = place + below(50);
        }
        expect_same_plans();
    }
}

/* Compares every window of a few bytes with every row near it, byte by byte. */
static void bounds_of_rows(void **unused) {
    (void)unused;
    static const char memory[64];
    const char *const base = memory + 32;
    for (int bytes = 1; bytes <= 5; bytes++)
        for (int first = -12; first <= 12; first++)
            for (int size = 0; size <= 14; size++)
                for (int number = -5; number <= 5; number++) {
                    const int begin = number * bytes, end = begin + bytes;
                    const bool leaves = begin < first || end > first + size;
                    const char *const window = base + first;
                    assert_int_equal(
                        redcc_row_leaves(window, (redcc_size)size, base, number, (redcc_size)bytes),
                        leaves);
                    assert_int_equal(
                        redcc_leaves(window, (redcc_size)size, base + begin, (redcc_size)bytes),
                        leaves);
                }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_in_order),  cmocka_unit_test(rows_without_order),
        cmocka_unit_test(strays),         cmocka_unit_test(idle_iterations),
        cmocka_unit_test(wide_touches),   cmocka_unit_test(stretches),
        cmocka_unit_test(bounds_of_rows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
