/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* REDCC_VALIDATE=1 with binned loops: correct executions pass. A record that is applied wrongly is
 * detected in any round, and the wrong results are kept. */
#include "base/memory.h"
#include "binned.h"
#include "bins/window.h"
#include "loop.h"
#include "problem.h"
#include "report.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include <cmocka.h>

/* A row of which only the beginning is mapped. */
enum { GAP = 1 << 16 };
struct far_row {
    double first;
    char gap[GAP - sizeof(double)];
};

BINNED_LOOP(sums, double, double, REDCC_SUM, REDCC_DOUBLE, 0, *r += e)
BINNED_LOOP(far, struct far_row, double, REDCC_SUM, REDCC_OTHER_TYPE, 0, r->first += e)
BINNED_LOOP(counts, int, int, REDCC_SUM, REDCC_INT32, 1, *r += e)

enum { ROWS = 500, TRIP = 6000, ROUND = 700 };
static struct bins_tuning usual;
static const double by = 1;
static int k[TRIP], ascending[TRIP], numbers[TRIP];
static double values[TRIP];

static void make_data(void) {
    unsigned long state = 99;
    for (int t = 0; t < TRIP; t++) {
        k[t] = (int)(next_random(&state) % ROWS);
        ascending[t] = t * ROWS / TRIP; /* each round updates other rows */
        values[t] = (double)(int)(next_random(&state) % 1000) * 0.1;
        numbers[t] = (int)(next_random(&state) % 1000);
    }
}

static const struct statistics *statistics_of(const struct binned_loop *loop) {
    return &((const struct loop_state *)loop->descriptor->loop.state)->reported.statistics;
}

/* ---- a deliberate fault ---------------------------------------------------------------------- */

static const redcc_stream *right;
static long applied_before_fault;

/* Applies records, and after the given number of calls one record a second time. */
static void apply_wrongly(const redcc_applied *applied) {
    right->apply(applied);
    if (applied->count == 0 || __atomic_fetch_sub(&applied_before_fault, 1, __ATOMIC_RELAXED) != 0)
        return;
    redcc_applied again = *applied;
    again.count = 1;
    again.ahead = 0;
    right->apply(&again);
}

/* Runs the loop with the fault after this number of calls of its apply function. */
static void run_wrongly(const struct binned_loop *loop, const struct binned_problem *problem,
                        long after) {
    redcc_stream wrong = loop->descriptor->streams[0];
    int last = 0;
    right = loop->descriptor->streams;
    wrong.apply = apply_wrongly;
    applied_before_fault = after;
    loop->descriptor->streams = &wrong;
    assert_true(loop->run(problem, 3, &last));
    loop->descriptor->streams = right;
}

/* ---- tests ----------------------------------------------------------------------------------- */

static void a_fault_is_found(void **unused) {
    (void)unused;
    static const long after[] = {0, 5, 60};
    for (int i = 0; i < 3; i++) {
        double found[ROWS] = {0}, expected[ROWS] = {0};
        struct binned_problem problem = {
            .trip = TRIP, .k = k, .value = values, .rows = expected, .by = &by};
        sums.oracle(&problem);
        problem.rows = found;
        redcc_bins_tuning.round = ROUND;
        run_wrongly(&sums, &problem, after[i]);
        assert_memory_not_equal(found, expected, sizeof found); /* the wrong results are kept */
        const struct validated *validated = &statistics_of(&sums)->validated;
        assert_int_equal(validated->executions, 1);
        assert_int_equal(validated->broken, 1);
        assert_true(validated->largest > 0);
        assert_string_equal(validated->name, "R");
        assert_in_range(validated->element, 0, ROWS - 1);
        assert_true(found[validated->element] != expected[validated->element]);
        assert_true(redcc_report_validation());
        redcc_loop_forget(&sums.descriptor->loop);
        redcc_bins_tuning = usual;
    }
}

static void what_is_right_is_found_right(void **unused) {
    (void)unused;
    const struct binned_loop *const loops[] = {&sums, &counts};
    const void *const contributions[] = {values, numbers};
    const int *const subscripts[] = {ascending, k};
    for (int i = 0; i < 2; i++) {
        double found[ROWS] = {0}, expected[ROWS] = {0};
        int last;
        struct binned_problem problem = {.trip = TRIP,
                                         .k = subscripts[i],
                                         .value = contributions[i],
                                         .rows = expected,
                                         .by = &by};
        loops[i]->oracle(&problem);
        problem.rows = found;
        redcc_bins_tuning.round = i ? INT64_MAX : ROUND;
        for (int call = 0; call < 3; call++) {
            memset(found, 0, sizeof found);
            assert_true(loops[i]->run(&problem, 2 + call, &last));
            assert_memory_equal(found, expected, sizeof found);
        }
        const struct loop_state *state = loops[i]->descriptor->loop.state;
        assert_int_equal(state->reported.statistics.validated.executions, 3);
        assert_int_equal(state->reported.statistics.validated.broken, 0);
        assert_int_equal(state->reported.statistics.validated.passed_over, 0);
        assert_int_equal(state->binning.copies.count > 0, i);
        redcc_loop_forget(&loops[i]->descriptor->loop);
        redcc_bins_tuning = usual;
    }
    assert_int_equal(redcc_memory_live(), 0);
}

/* Without memory for copies nothing is compared, but the loop is executed. */
static void without_memory_nothing_is_compared(void **unused) {
    (void)unused;
    long compared = 0, binned = 0;
    for (long failure = 0; failure < 60; failure++) {
        double found[ROWS] = {0}, expected[ROWS] = {0};
        int last;
        struct binned_problem problem = {
            .trip = TRIP, .k = k, .value = values, .rows = expected, .by = &by};
        sums.oracle(&problem);
        problem.rows = found;
        redcc_bins_tuning.round = ROUND;
        redcc_memory_fail_after(failure);
        const bool done = sums.run(&problem, 2, &last);
        redcc_memory_fail_after(-1);
        if (!done)
            sums.oracle(&problem);
        assert_memory_equal(found, expected, sizeof found);
        if (sums.descriptor->loop.state) {
            assert_int_equal(statistics_of(&sums)->validated.broken, 0);
            compared += statistics_of(&sums)->validated.executions;
            binned += done;
        }
        redcc_loop_forget(&sums.descriptor->loop);
        assert_int_equal(redcc_memory_live(), 0);
        redcc_bins_tuning = usual;
    }
    assert_in_range(compared, 1, binned - 1);
}

/* Rows at arbitrary addresses: the memory between them must be neither read nor written. */
static void scattered_rows_are_passed_over(void **unused) {
    (void)unused;
    enum { FAR = 50 };
    const size_t bytes = (size_t)GAP * (FAR + 1);
    char *const all =
        mmap(NULL, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    assert_ptr_not_equal(all, MAP_FAILED);
    const redcc_int first = (redcc_int)((uintptr_t)all / GAP + 1);
    double *row[FAR], expected[FAR] = {0};
    for (int r = 0; r < FAR; r++) {
        row[r] = (double *)((uintptr_t)(first + r) * GAP);
        assert_int_equal(mprotect(row[r], 1 << 12, PROT_READ | PROT_WRITE), 0);
    }
    int *const address = malloc(TRIP * sizeof *address), last;
    for (int t = 0; t < TRIP; t++) {
        address[t] = (int)(first + k[t] % FAR);
        expected[k[t] % FAR] += values[t];
    }
    const struct binned_problem problem = {.trip = TRIP, .k = address, .value = values, .by = &by};
    redcc_bins_tuning.round = ROUND; /* so that one execution has several rounds */
    assert_true(far.run(&problem, 3, &last));
    for (int r = 0; r < FAR; r++)
        assert_memory_equal(row[r], &expected[r], sizeof(double));
    assert_int_equal(statistics_of(&far)->validated.executions, 0);
    assert_int_equal(statistics_of(&far)->validated.passed_over, 1);
    redcc_loop_forget(&far.descriptor->loop);
    redcc_bins_tuning = usual;
    free(address);
    munmap(all, bytes);
    assert_int_equal(redcc_memory_live(), 0);
}

int main(void) {
    usual = redcc_bins_tuning;
    make_data();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_fault_is_found),
        cmocka_unit_test(what_is_right_is_found_right),
        cmocka_unit_test(scattered_rows_are_passed_over),
        cmocka_unit_test(without_memory_nothing_is_compared),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
