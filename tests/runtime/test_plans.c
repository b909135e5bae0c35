/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* When a plan is reused, when it is not, and when the loop is refused. Run with a named method. */
#include "base/memory.h"
#include "loop.h"
#include "problem.h"
#include "settings.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include <cmocka.h>

enum { THREADS = 3 };

struct fixture {
    struct problem problem;
    struct described described;
    double *expected;
};

static void fixture_begin(struct fixture *fixture, int number) {
    fixture->problem = problem_new(number, true);
    problem_describe(&fixture->problem, &fixture->described);
    fixture->expected = malloc((size_t)fixture->problem.doubles * sizeof(double));
}

static void fixture_end(struct fixture *fixture) {
    redcc_loop_forget(&fixture->described.loop);
    problem_free(&fixture->problem);
    free(fixture->expected);
    assert_int_equal(redcc_memory_live(), 0);
}

static const struct statistics *statistics_of(const struct fixture *fixture) {
    return &((const struct loop_state *)fixture->described.loop.state)->reported.statistics;
}

/* Runs the loop and compares with the expected result. Returns whether it ran in parallel. */
static int run_right(struct fixture *fixture) {
    struct problem *problem = &fixture->problem;
    const size_t bytes = (size_t)problem->doubles * sizeof(double);
    long last;
    problem_reset(problem);
    problem_oracle(problem);
    memcpy(fixture->expected, problem->first, bytes);
    problem_reset(problem);
    const int parallel = problem_run(problem, &fixture->described, THREADS, &last);
    assert_memory_equal(fixture->expected, problem->first, bytes);
    return parallel;
}

static void expect_plans(const struct fixture *fixture, long built, long reused) {
    assert_int_equal(statistics_of(fixture)->plans_built, built);
    assert_int_equal(statistics_of(fixture)->plans_reused, reused);
}

static void changed_contents_are_noticed(void **unused) {
    (void)unused;
    struct fixture fixture;
    fixture_begin(&fixture, 1);
    struct problem *problem = &fixture.problem;
    assert_true(run_right(&fixture));
    assert_true(run_right(&fixture));
    expect_plans(&fixture, 1, 1);
    for (long k = 0; k < problem->touches; k += 501) { /* changes one subscript at a time */
        problem->row[k] = (problem->row[k] + 1000) % problem->rows;
        assert_true(run_right(&fixture));
    }
    expect_plans(&fixture, 1 + (problem->touches + 500) / 501, 1);
    assert_true(run_right(&fixture));
    fixture_end(&fixture);
}

/* A loop with one touch per iteration, whose array `start` has some megabytes. */
static struct problem long_problem(void) {
    enum { TRIP = 900000, ROWS = 5000 };
    struct problem problem = {
        .name = "long", .trip = TRIP, .touches = TRIP, .rows = ROWS, .width = 1, .doubles = ROWS};
    problem.start = malloc((TRIP + 1) * sizeof(int));
    problem.row = malloc(TRIP * sizeof(int));
    problem.other = malloc(TRIP * sizeof(int));
    problem.value = malloc(TRIP * sizeof(double));
    problem.first = malloc(ROWS * sizeof(double));
    for (int t = 0; t < TRIP; t++) {
        problem.start[t] = t;
        problem.row[t] = problem.other[t] = (int)((long)t * ROWS / TRIP);
        problem.value[t] = t % 17;
    }
    problem.start[TRIP] = TRIP;
    return problem;
}

/* A source of this length is read in pieces, during the inspection. */
static void changes_in_every_piece_are_noticed(void **unused) {
    (void)unused;
    struct fixture fixture = {.problem = long_problem()};
    struct problem *problem = &fixture.problem;
    problem_describe(problem, &fixture.described);
    fixture.expected = malloc((size_t)problem->doubles * sizeof(double));
    assert_true(run_right(&fixture));
    assert_true(run_right(&fixture));
    expect_plans(&fixture, 1, 1);
    long changes = 0;
    for (long t = 1; t < problem->trip; t += 99991, changes++) { /* t - 1 loses its touch to t */
        problem->start[t]--;
        assert_true(run_right(&fixture));
    }
    expect_plans(&fixture, 1 + changes, 1);
    assert_true(run_right(&fixture));
    expect_plans(&fixture, 1 + changes, 2);
    fixture_end(&fixture);
}

static void values_may_change(void **unused) {
    (void)unused;
    struct fixture fixture;
    fixture_begin(&fixture, 0);
    assert_true(run_right(&fixture));
    for (long k = 0; k < fixture.problem.touches; k++)
        fixture.problem.value[k] += 3;
    assert_true(run_right(&fixture));
    expect_plans(&fixture, 1, 1);
    fixture_end(&fixture);
}

static void several_trip_counts_are_kept(void **unused) {
    (void)unused;
    struct fixture fixture;
    fixture_begin(&fixture, 2);
    const long whole = fixture.problem.trip;
    for (int round = 0; round < 2; round++)
        for (int part = 1; part <= 4; part++) {
            fixture.problem.trip = whole * part / 4;
            assert_true(run_right(&fixture));
        }
    expect_plans(&fixture, 4, 4);
    fixture_end(&fixture);
}

static void more_trip_counts_than_are_kept(void **unused) {
    (void)unused;
    struct fixture fixture;
    fixture_begin(&fixture, 2);
    for (int round = 0; round < 3; round++)
        for (long part = 1; part <= 7; part++) {
            fixture.problem.trip = 500 * part;
            assert_true(run_right(&fixture));
        }
    expect_plans(&fixture, 21, 0);
    fixture_end(&fixture);
}

/* The contents of `start` determine the length of `row`. If `row` becomes shorter at the same
 * address, nothing beyond its end may be read: the remaining pages are unreadable. */
static void shorter_arrays_are_not_read_beyond_their_end(void **unused) {
    (void)unused;
    struct fixture fixture;
    fixture_begin(&fixture, 2);
    struct problem *problem = &fixture.problem;
    const size_t page = 4096, bytes = (size_t)problem->touches * sizeof(int);
    const size_t pages = (bytes + page - 1) / page * page;
    int *const row = problem->row;
    char *mapped = mmap(NULL, pages, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    assert_ptr_not_equal(mapped, MAP_FAILED);
    memcpy(mapped, row, bytes);
    problem->row = (int *)mapped;
    assert_true(run_right(&fixture));
    for (long t = 0; t <= problem->trip; t++) /* half the number of touches */
        problem->start[t] = problem->start[t] / 2;
    problem->touches = problem->start[problem->trip];
    const size_t kept = ((size_t)problem->touches * sizeof(int) + page - 1) / page * page;
    assert_int_equal(mprotect(mapped + kept, pages - kept, PROT_NONE), 0);
    assert_true(run_right(&fixture));
    expect_plans(&fixture, 2, 0);
    munmap(mapped, pages);
    problem->row = row;
    fixture_end(&fixture);
}

static void a_plan_moves_to_other_arrays(void **unused) {
    (void)unused;
    struct fixture fixture;
    fixture_begin(&fixture, 9);
    struct problem *problem = &fixture.problem;
    assert_true(run_right(&fixture));
    double *const first = problem->first, *const second = problem->second;
    const size_t bytes = (size_t)problem->doubles * sizeof(double);
    problem->first = malloc(bytes);
    problem->second = malloc((size_t)problem->second_rows * 9 * sizeof(double));
    problem->second[0] = 0;
    assert_true(run_right(&fixture));
    expect_plans(&fixture, 1, 1);
    free(first);
    free(second);
    fixture_end(&fixture);
}

/* Other pointers, one of which now points into the other's array: the cuts are no longer valid. */
static void a_plan_does_not_move_to_arrays_that_overlap(void **unused) {
    (void)unused;
    struct fixture fixture;
    fixture_begin(&fixture, 11);
    struct problem *problem = &fixture.problem;
    double *const second = problem->second;
    double *const apart = calloc((size_t)problem->second_rows, sizeof(double));
    problem->second = apart;
    assert_true(run_right(&fixture));
    problem->second = second;
    assert_true(run_right(&fixture));
    expect_plans(&fixture, 2, 0);
    problem->second = second - 8;
    assert_true(run_right(&fixture));
    expect_plans(&fixture, 3, 0);
    problem->second = second;
    assert_true(run_right(&fixture));
    expect_plans(&fixture, 3, 1);
    free(apart);
    fixture_end(&fixture);
}

static void unverifiable_loops_are_inspected_each_time(void **unused) {
    (void)unused;
    struct fixture fixture;
    fixture_begin(&fixture, 0);
    fixture.described.loop.flags = REDCC_SELECTS;
    for (int call = 0; call < 3; call++)
        assert_true(run_right(&fixture));
    expect_plans(&fixture, 3, 0);
    fixture_end(&fixture);
}

/* Reads overlap updates: the runtime executes nothing, and the report names the two arrays. */
static void an_overlap_is_refused(void **unused) {
    (void)unused;
    struct fixture fixture;
    fixture_begin(&fixture, 0);
    struct problem *problem = &fixture.problem;
    double *const first = problem->first, *const value = problem->value;
    const size_t doubles = (size_t)problem->doubles + (size_t)problem->touches;
    double *both = malloc(doubles * sizeof *both);
    double *expected = malloc(doubles * sizeof *both);
    for (int by = -1; by <= 1; by++) { /* overlapping by 7 elements, or adjacent */
        long last;
        problem->first = both;
        problem->value = both + problem->doubles - (by == -1) * 7;
        for (size_t i = 0; i < doubles; i++)
            both[i] = (double)(i % 11);
        memcpy(expected, both, doubles * sizeof *both);
        problem_oracle(problem);
        for (size_t i = 0; i < doubles; i++) {
            const double result = both[i];
            both[i] = expected[i];
            expected[i] = result;
        }
        assert_int_equal(problem_run(problem, &fixture.described, THREADS, &last), by >= 0);
        assert_memory_equal(expected, both, doubles * sizeof *both);
        assert_int_equal(statistics_of(&fixture)->why.overlap[0].count, 1);
        assert_string_equal(statistics_of(&fixture)->why.overlap[0].text,
                            "'value' overlaps 'first'");
    }
    problem->first = first;
    problem->value = value;
    free(both);
    free(expected);
    fixture_end(&fixture);
}

/* A plan exists, but now the reads overlap the updated array, with the same subscripts. */
static void an_overlap_is_refused_with_a_plan_at_hand(void **unused) {
    (void)unused;
    struct fixture fixture;
    fixture_begin(&fixture, 0);
    struct problem *problem = &fixture.problem;
    double *const value = problem->value;
    assert_true(run_right(&fixture));
    problem->value = problem->first + 5; /* only the first touches are left to read */
    for (long t = 0; t <= problem->trip; t++)
        if (problem->start[t] > 1900)
            problem->start[t] = 1900;
    problem->value = value;
    assert_true(run_right(&fixture));
    problem->value = problem->first + 5;
    double *copy = malloc((size_t)problem->doubles * sizeof *copy);
    long last;
    problem_reset(problem);
    problem_oracle(problem);
    memcpy(copy, problem->first, (size_t)problem->doubles * sizeof *copy);
    problem_reset(problem);
    assert_false(problem_run(problem, &fixture.described, THREADS, &last));
    assert_memory_equal(copy, problem->first, (size_t)problem->doubles * sizeof *copy);
    problem->value = value;
    assert_true(run_right(&fixture));
    free(copy);
    fixture_end(&fixture);
}

static void overlapping_arrays_out_of_step_are_refused(void **unused) {
    (void)unused;
    struct fixture fixture;
    fixture_begin(&fixture, 11);
    struct problem *problem = &fixture.problem;
    /* pretends that rows have 3 elements in one array and 2 in the other, at overlapping addresses
     */
    fixture.described.arrays[0].unit = 24;
    fixture.described.arrays[1].unit = 16;
    assert_false(run_right(&fixture));
    assert_int_equal(atomic_load(&statistics_of(&fixture)->fallback[REASON_OUT_OF_STEP]), 1);
    (void)problem;
    fixture_end(&fixture);
}

/* LOCALWRITE keeps each element's order for all operators. Other methods would mix different
 * operators up, so they must refuse. */
static void overlapping_arrays_of_unlike_operators(void **unused) {
    (void)unused;
    struct fixture fixture;
    fixture_begin(&fixture, 11);
    fixture.described.arrays[1].operation = REDCC_PRODUCT;
    const int parallel = run_right(&fixture);
    const bool refused = atomic_load(&statistics_of(&fixture)->fallback[REASON_MIXED]) == 1;
    assert_int_equal(parallel, !refused);
    assert_int_equal(refused, redcc_settings()->method->keeps != REDCC_ORDER_SERIAL);
    fixture_end(&fixture);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(changed_contents_are_noticed),
        cmocka_unit_test(changes_in_every_piece_are_noticed),
        cmocka_unit_test(values_may_change),
        cmocka_unit_test(several_trip_counts_are_kept),
        cmocka_unit_test(more_trip_counts_than_are_kept),
        cmocka_unit_test(shorter_arrays_are_not_read_beyond_their_end),
        cmocka_unit_test(a_plan_moves_to_other_arrays),
        cmocka_unit_test(a_plan_does_not_move_to_arrays_that_overlap),
        cmocka_unit_test(unverifiable_loops_are_inspected_each_time),
        cmocka_unit_test(an_overlap_is_refused),
        cmocka_unit_test(an_overlap_is_refused_with_a_plan_at_hand),
        cmocka_unit_test(overlapping_arrays_out_of_step_are_refused),
        cmocka_unit_test(overlapping_arrays_of_unlike_operators),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
