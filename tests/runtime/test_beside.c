/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Subscripts whose ranges overlap, as those of row_start[i] and row_start[i + 1]: bytes that belong
 * to both ranges are read only once, and yet no change is missed.
 *
 *     for (t = 0; t < trip; t++) { b[p[t]] += t; b[q[t]] -= 2 * t; } */
#include "loop.h"

#include <omp.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { THREADS = 3, TRIP = 6000, ROWS = 500, MARGIN = 8 };

static int pool[TRIP + 2 * MARGIN];
static int *const p = pool + MARGIN;
static double b[ROWS], expected[ROWS];

static const redcc_array arrays[] = {{"b", REDCC_SUM, REDCC_DOUBLE, 8, 8, 0}};
static const redcc_source sources[] = {{"p", 1}, {"q", 1}};
static redcc_loop loop = {"test_beside.c",  1, "execute", REDCC_ORDER_SERIAL,
                          REDCC_VERIFIABLE, 1, arrays,    2,
                          sources,          0, 0};

static redcc_extent all_of(const int *subscript) {
    return (redcc_extent){(const char *)subscript, (const char *)(subscript + TRIP)};
}

static void execute(const int *q) {
    void *const bases[] = {b};
    const redcc_extent known[] = {all_of(p), all_of(q)};
    redcc_call call;
    assert_true(redcc_enter(&call, &loop, TRIP, bases, known, 0, THREADS, 0));
#pragma omp parallel num_threads(call.threads)
    {
        redcc_worker worker;
        redcc_join(&worker, &call, omp_get_thread_num(), omp_get_num_threads());
        while (redcc_inspect(&worker))
            for (redcc_int t = worker.first; t < worker.last; t += worker.stride) {
                redcc_touch(&worker, 0, &b[p[t]], sizeof *b);
                redcc_touch(&worker, 0, &b[q[t]], sizeof *b);
                redcc_iteration_done(&worker);
            }
        while (redcc_next(&worker)) {
            const redcc_owner own = worker.owner[0];
            for (const redcc_iterations *run = worker.run; run != worker.run_end; run++) {
                redcc_int t = worker.origin + run->begin;
                for (redcc_int n = 0; n < run->count_and_check / 2; n++, t++) {
                    if (!(run->count_and_check & 1) || redcc_owns(&own, &b[p[t]]))
                        b[p[t]] += (double)t;
                    if (!(run->count_and_check & 1) || redcc_owns(&own, &b[q[t]]))
                        b[q[t]] -= 2 * (double)t;
                }
            }
        }
    }
    assert_true(redcc_leave(&call));
}

/* Executes the loop and compares the results. Returns true if a plan was reused. */
static bool execute_right(const int *q) {
    memset(expected, 0, sizeof expected);
    memset(b, 0, sizeof b);
    for (int t = 0; t < TRIP; t++) {
        expected[p[t]] += t;
        expected[q[t]] -= 2 * t;
    }
    const struct loop_state *state = loop.state;
    const long before = state ? state->reported.statistics.plans_reused : 0;
    execute(q);
    assert_memory_equal(b, expected, sizeof b);
    state = loop.state;
    return state->reported.statistics.plans_reused > before;
}

static void fill(void) {
    unsigned state = 7;
    for (int t = 0; t < TRIP + 2 * MARGIN; t++) {
        state = state * 1664525u + 1013904223u;
        pool[t] = (int)(state >> 16) % ROWS;
    }
}

static void changes_are_seen_wherever_they_lie(void **unused) {
    (void)unused;
    for (int distance = -MARGIN; distance <= MARGIN; distance += distance < -2 ? 6 : 1) {
        fill();
        redcc_loop_forget(&loop);
        assert_false(execute_right(p + distance));
        assert_true(execute_right(p + distance));
        for (int t = -MARGIN; t < TRIP + MARGIN; t += t < MARGIN || t >= TRIP - MARGIN ? 1 : 611) {
            const bool read = (t >= 0 && t < TRIP) || (t >= distance && t < distance + TRIP);
            p[t] = (p[t] + 100) % ROWS;
            assert_int_equal(execute_right(p + distance), !read);
        }
    }
    redcc_loop_forget(&loop);
}

/* The bytes of both sources are unchanged, but one source begins elsewhere. */
static void places_are_compared_too(void **unused) {
    (void)unused;
    fill();
    for (int t = -MARGIN; t < MARGIN; t++)
        p[t] = p[TRIP - MARGIN + t] = 3;
    for (int first = -MARGIN; first <= MARGIN; first++)
        for (int second = -MARGIN; second <= MARGIN; second++) {
            redcc_loop_forget(&loop);
            assert_false(execute_right(p + first));
            assert_int_equal(execute_right(p + second), first == second);
        }
    redcc_loop_forget(&loop);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(changes_are_seen_wherever_they_lie),
        cmocka_unit_test(places_are_compared_too),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
