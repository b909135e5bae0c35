/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Owners by majority votes, on a strip of cells whose boundary cells are rows appended at the end.
 * Each cell updates itself and its four neighbours. Run with localwrite-direct by name. */
#include "base/memory.h"
#include "loop.h"
#include "ownership/cuts.h"
#include "ownership/estimate.h"
#include "ownership/owner_map.h"
#include "problem.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum {
    WIDE = 4,
    LONG = 1000,
    CELLS = WIDE * LONG,
    ROWS = CELLS + 2 * LONG,
    TOUCHED = 5,
    WIDTH = 3,
    MARGIN = 500 /* rows before and after the strip, which few iterations touch */
};

static const int threads_tried[] = {1, 2, 3, 7, 16, 33};

/* A strip of cells. */
struct strip {
    int wide, long_;
};

static const struct strip usual = {WIDE, LONG};

static int cells_of(struct strip of) {
    return of.wide * of.long_;
}

/* Returns the row of the cell at (x, y); outside of the strip, the row of the boundary cell. */
static int row_at(struct strip of, int x, int y) {
    y = y < 0 ? 0 : y >= of.long_ ? of.long_ - 1 : y;
    return x < 0 ? cells_of(of) + y : x >= of.wide ? cells_of(of) + of.long_ + y : of.wide * y + x;
}

static void touched_by(struct strip of, int cell, int *row) {
    const int x = cell % of.wide, y = cell / of.wide;
    const int next[TOUCHED][2] = {{x, y}, {x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}};
    for (int k = 0; k < TOUCHED; k++)
        row[k] = row_at(of, next[k][0], next[k][1]);
}

/* ---- the map --------------------------------------------------------------------------------- */

static double strip[ROWS][WIDTH];

static const redcc_array array = {"strip", REDCC_SUM, REDCC_DOUBLE, 8, sizeof *strip, 0};

struct fixture {
    struct partition partition;
    struct sample sample;
    const struct sample *samples[1];
    struct range touched;
};

static void begin(struct fixture *fixture, const void *base, uint32_t owners) {
    const redcc_loop loop = {.arrays = &array, .array_count = 1};
    void *bases[] = {(void *)(uintptr_t)base};
    assert_true(redcc_sample_begin(&fixture->sample, TOUCHED * CELLS, 0));
    for (int cell = 0; cell < CELLS; cell++) {
        int row[TOUCHED];
        touched_by(usual, cell, row);
        for (int k = 0; k < TOUCHED; k++)
            redcc_sample_add(&fixture->sample, (uintptr_t)strip[row[k]], 0, 1, 0);
        redcc_sample_next_iteration(&fixture->sample);
    }
    fixture->samples[0] = &fixture->sample;
    fixture->touched = (struct range){(uintptr_t)strip, (uintptr_t)strip[ROWS]};
    assert_true(redcc_partition_begin(&fixture->partition, &loop, bases, owners));
    assert_true(redcc_choose_cuts(&fixture->partition, fixture->samples, 1));
}

static void end(struct fixture *fixture) {
    redcc_partition_end(&fixture->partition);
    redcc_sample_end(&fixture->sample);
    assert_int_equal(redcc_memory_live(), 0);
}

static void vote(struct fixture *fixture) {
    redcc_owner_map_vote(&fixture->partition, &fixture->touched, fixture->samples, 1);
}

static uint32_t owner_of(const struct fixture *fixture, int row) {
    return redcc_mapped_owner(&fixture->partition, 0, (uintptr_t)strip[row]);
}

static double share_of(const struct fixture *fixture) {
    struct estimate estimate;
    assert_true(redcc_estimate(&fixture->partition, fixture->samples, 1, &estimate));
    return estimate.share;
}

static void borders_belong_to_those_beside_them(void **unused) {
    (void)unused;
    for (size_t i = 0; i < sizeof threads_tried / sizeof *threads_tried; i++) {
        const uint32_t owners = (uint32_t)threads_tried[i];
        struct fixture fixture;
        begin(&fixture, strip, owners);
        const double by_cuts = share_of(&fixture);
        vote(&fixture);
        assert_non_null(fixture.partition.map.owner);
        int strays = 0;
        for (int y = 0; y < LONG; y++)
            for (int side = 0; side < 2; side++)
                strays += owner_of(&fixture, row_at(usual, side ? WIDE : -1, y)) !=
                          owner_of(&fixture, row_at(usual, side ? WIDE - 1 : 0, y));
        assert_in_range(strays, 0, 8 * (owners - 1));
        assert_true(share_of(&fixture) < 1.1 / owners + 0.02);
        assert_true(owners == 1 || share_of(&fixture) < 0.9 * by_cuts);
        end(&fixture);
    }
}

/* No row is divided among owners, and each touched byte has an owner. */
static void blocks_are_of_whole_rows(void **unused) {
    (void)unused;
    struct fixture fixture;
    begin(&fixture, strip[CELLS / 2], 3); /* the base is in the middle of the array */
    fixture.touched = (struct range){(uintptr_t)strip[10], (uintptr_t)strip[ROWS - 200]};
    vote(&fixture);
    const uint32_t first = owner_of(&fixture, 10), last = owner_of(&fixture, ROWS - 201);
    for (int all = 0; all < 2; all++) {
        const struct group_map *it = fixture.partition.map.of;
        assert_int_equal(it->bytes % sizeof *strip, 0);
        assert_int_equal(it->first % (ptrdiff_t)sizeof *strip, 0);
        const uintptr_t from = fixture.partition.base[0] + (uintptr_t)it->first;
        assert_true(from <= fixture.touched.first);
        assert_true(from + (uintptr_t)it->count * it->bytes >= fixture.touched.end);
        assert_int_equal(owner_of(&fixture, 0), first);
        assert_int_equal(owner_of(&fixture, ROWS - 1), last);
        assert_int_equal(owner_of(&fixture, CELLS / 2), 1);
        for (int row = 0; row < ROWS; row++)
            assert_in_range(owner_of(&fixture, row), 0, 2);
        fixture.touched = (struct range){(uintptr_t)strip, (uintptr_t)strip[ROWS]};
        redcc_owner_map_extend(&fixture.partition, &fixture.touched);
        assert_non_null(fixture.partition.map.owner);
    }
    end(&fixture);
}

static void owners_move_with_the_arrays(void **unused) {
    (void)unused;
    struct fixture fixture;
    begin(&fixture, strip, 3);
    void *const bases[] = {strip[100]};
    const uintptr_t first = redcc_cuts(&fixture.partition, 0)[1];
    const uintptr_t second = redcc_cuts(&fixture.partition, 0)[2];
    redcc_partition_move(&fixture.partition, bases);
    const uintptr_t *cut = redcc_cuts(&fixture.partition, 0);
    assert_int_equal(fixture.partition.base[0], (uintptr_t)strip[100]);
    assert_int_equal(cut[0], 0);
    assert_int_equal(cut[1], first + 100 * sizeof *strip);
    assert_int_equal(cut[2], second + 100 * sizeof *strip);
    assert_int_equal(cut[3], UINTPTR_MAX);
    end(&fixture);
}

/* Two arrays: iterations of the lower and upper half of the first are mixed in the second. The best
 * cuts of the second array are after its first and after its last element. A cut midway between
 * them is the worst. */
static void a_cut_is_one_of_the_best(void **unused) {
    (void)unused;
    enum { ITERATIONS = 6, OWNERS = 2 };
    static double first[ITERATIONS], second[ITERATIONS];
    static const int of_first[ITERATIONS] = {0, 3, 4, 1, 2, 5};
    static const redcc_array arrays[] = {{"first", REDCC_SUM, REDCC_DOUBLE, 8, 8, 0},
                                         {"second", REDCC_SUM, REDCC_DOUBLE, 8, 8, 0}};
    const redcc_loop loop = {.arrays = arrays, .array_count = 2};
    void *bases[] = {first, second};
    struct fixture fixture;
    assert_true(redcc_sample_begin(&fixture.sample, 2 * ITERATIONS, 0));
    for (int i = 0; i < ITERATIONS; i++) {
        redcc_sample_add(&fixture.sample, (uintptr_t)&first[of_first[i]], 0, 1, 0);
        if (i < ITERATIONS - 1) /* the last iteration touches only the first array */
            redcc_sample_add(&fixture.sample, (uintptr_t)&second[i], 1, 1, 0);
        redcc_sample_next_iteration(&fixture.sample);
    }
    fixture.samples[0] = &fixture.sample;
    assert_true(redcc_partition_begin(&fixture.partition, &loop, bases, OWNERS));
    assert_true(redcc_choose_cuts(&fixture.partition, fixture.samples, 1));
    assert_int_equal(redcc_cuts(&fixture.partition, 0)[1], (uintptr_t)&first[3]);
    assert_int_equal(redcc_cuts(&fixture.partition, 1)[1], (uintptr_t)&second[1]);
    end(&fixture);
}

static void some_have_none(void **unused) {
    (void)unused;
    struct fixture fixture;
    begin(&fixture, NULL, 2); /* the rows are scattered in memory */
    vote(&fixture);
    assert_null(fixture.partition.map.owner);
    end(&fixture);
    begin(&fixture, strip, REDCC_OWNERS_MOST + 1);
    vote(&fixture);
    assert_null(fixture.partition.map.owner);
    end(&fixture);
    begin(&fixture, strip, 2);
    vote(&fixture);
    fixture.touched.end += (uintptr_t)1 << 40; /* too many blocks */
    redcc_owner_map_extend(&fixture.partition, &fixture.touched);
    assert_null(fixture.partition.map.owner);
    end(&fixture);
}

/* ---- cells of particles ---------------------------------------------------------------------- */

enum { SIDE = 12, SLOTS = 8, EACH_SEVENTH = 7 };

static double energy[SIDE * SIDE * SIDE * SLOTS], force[SIDE * SIDE * SIDE * SLOTS][3];

/* Adds the touches of a cell's iteration: the rows of its particles and of those in all adjacent
 * cells; of the energies only those in the cells below. */
static void add_touches(struct sample *sample, int cell) {
    const int z = cell / (SIDE * SIDE), y = cell / SIDE % SIDE, x = cell % SIDE;
    for (int near = 0; near < 27; near++) {
        const int at[3] = {x + near % 3 - 1, y + near / 3 % 3 - 1, z + near / 9 - 1};
        bool is_inside = true;
        for (int axis = 0; axis < 3; axis++)
            is_inside = is_inside && at[axis] >= 0 && at[axis] < SIDE;
        const int row = is_inside ? (at[0] + SIDE * (at[1] + SIDE * at[2])) * SLOTS : 0;
        for (int particle = 0; is_inside && particle < 2; particle++) {
            if (near < 9)
                redcc_sample_add(sample, (uintptr_t)&energy[row + particle], 0, 1, 0);
            redcc_sample_add(sample, (uintptr_t)force[row + particle], 1, 1, 0);
        }
    }
    redcc_sample_next_iteration(sample);
}

/* Only each seventh cell is sampled, so votes are few and vary. The owners' parts are consecutive
 * nevertheless, and the same in both arrays. */
static void borders_are_smooth(void **unused) {
    (void)unused;
    static const redcc_array arrays[] = {{"energy", REDCC_SUM, REDCC_DOUBLE, 8, 8, 0},
                                         {"force", REDCC_SUM, REDCC_DOUBLE, 8, 24, 0}};
    const redcc_loop loop = {.arrays = arrays, .array_count = 2};
    const int cells = SIDE * SIDE * SIDE;
    for (uint32_t owners = 2; owners <= 7; owners++) {
        struct fixture fixture;
        void *bases[] = {energy, force};
        assert_true(redcc_sample_begin(&fixture.sample, 27 * 4 * (size_t)cells, 0));
        for (int cell = (int)owners % EACH_SEVENTH; cell < cells; cell += EACH_SEVENTH)
            add_touches(&fixture.sample, cell);
        fixture.samples[0] = &fixture.sample;
        const struct range touched[] = {{(uintptr_t)energy, (uintptr_t)(energy + cells * SLOTS)},
                                        {(uintptr_t)force, (uintptr_t)(force + cells * SLOTS)}};
        assert_true(redcc_partition_begin(&fixture.partition, &loop, bases, owners));
        redcc_owner_map_vote(&fixture.partition, touched, fixture.samples, 1);
        assert_non_null(fixture.partition.map.owner);
        uint32_t changes = 0, before = 0;
        for (int row = 0; row < cells * SLOTS; row++) {
            const uint32_t owner =
                redcc_mapped_owner(&fixture.partition, 0, (uintptr_t)&energy[row]);
            assert_int_equal(redcc_mapped_owner(&fixture.partition, 1, (uintptr_t)force[row]),
                             owner);
            changes += owner != before;
            before = owner;
        }
        assert_int_equal(changes, owners - 1);
        end(&fixture);
    }
}

/* ---- the loop -------------------------------------------------------------------------------- */

static struct problem strip_problem(struct strip of) {
    const int cells = cells_of(of), rows = cells + 2 * of.long_ + 2 * MARGIN;
    struct problem problem = {.name = "strip",
                              .trip = cells,
                              .touches = (long)cells * TOUCHED,
                              .rows = rows,
                              .width = WIDTH,
                              .doubles = (long)rows * WIDTH};
    unsigned long state = 5;
    problem.start = malloc((size_t)(cells + 1) * sizeof *problem.start);
    problem.row = malloc((size_t)problem.touches * sizeof *problem.row);
    problem.other = calloc((size_t)problem.touches, sizeof *problem.other);
    problem.value = malloc((size_t)problem.touches * sizeof *problem.value);
    problem.first = malloc((size_t)problem.doubles * sizeof *problem.first);
    for (int cell = 0; cell <= cells; cell++)
        problem.start[cell] = cell * TOUCHED;
    for (int cell = 0; cell < cells; cell++)
        touched_by(of, cell, problem.row + (ptrdiff_t)cell * TOUCHED);
    for (long k = 0; k < problem.touches; k++)
        problem.row[k] += MARGIN;
    for (long k = 0; k < problem.touches; k++)
        problem.value[k] = 1.0 / (double)(1 + next_random(&state) % 1000);
    return problem;
}

static double replication_of(const redcc_loop *loop, struct strip of) {
    struct loop_state *state = redcc_made_state_of((redcc_loop *)(uintptr_t)loop);
    return (double)state->reported.statistics.extra.executed / (double)cells_of(of);
}

/* Returns the expected results, which the caller frees. */
static double *results_of(struct problem *problem, size_t bytes) {
    double *results = malloc(bytes);
    problem_reset(problem);
    problem_oracle(problem);
    memcpy(results, problem->first, bytes);
    return results;
}

static void same_bits_for_any_owners(void **unused) {
    (void)unused;
    struct problem problem = strip_problem(usual);
    const size_t bytes = (size_t)problem.doubles * sizeof(double);
    double *expected = results_of(&problem, bytes);
    for (size_t i = 0; i < sizeof threads_tried / sizeof *threads_tried; i++) {
        struct described described;
        long last;
        problem_describe(&problem, &described);
        problem_reset(&problem);
        const int threads = threads_tried[i];
        assert_int_equal(problem_run(&problem, &described, threads, &last), threads > 1);
        if (threads > 1) {
            assert_memory_equal(expected, problem.first, bytes);
            assert_int_equal(last, 3 * (CELLS - 1) + 1);
            assert_true(replication_of(&described.loop, usual) < 1 + 0.02 * threads);
        }
        redcc_loop_forget(&described.loop);
    }
    free(expected);
    problem_free(&problem);
}

/* One iteration in 15 is sampled. In a strip of five columns, the sample must nevertheless have
 * cells of the last column, which alone updates half of the boundary cells. */
static void samples_have_all_columns(void **unused) {
    (void)unused;
    enum { THREADS = 2 };
    const struct strip of = {5, 800};
    struct problem problem = strip_problem(of);
    struct described described;
    long last;
    problem_describe(&problem, &described);
    problem_reset(&problem);
    assert_true(problem_run(&problem, &described, THREADS, &last));
    assert_true(replication_of(&described.loop, of) < 1.015);
    redcc_loop_forget(&described.loop);
    problem_free(&problem);
}

/* Changes what the given execution touches, so that it differs from the execution for which the
 * owners were chosen. */
static void change(struct problem *problem, int execution) {
    double *const before = problem->first;
    switch (execution) {
    case 1: /* the array is at another address */
        problem->first = malloc((size_t)problem->doubles * sizeof *problem->first);
        free(before);
        break;
    case 2: /* the execution touches rows before and after all that had owners */
        problem->row[0] = 0;
        problem->row[problem->touches - 1] = ROWS + 2 * MARGIN - 1;
        break;
    case 3: /* fewer iterations, nearly all of them with one owner */
        problem->trip = CELLS / 2 + 1;
        break;
    case 4: /* no two iterations touch neighbouring rows */
        problem->trip = CELLS;
        for (long k = 0; k < problem->touches; k++)
            problem->row[k] = (int)((k * 7919) % (ROWS + 2 * MARGIN));
        break;
    default:
        break;
    }
}

static void owners_are_kept(void **unused) {
    (void)unused;
    enum { EXECUTIONS = 7 };
    for (size_t i = 1; i < sizeof threads_tried / sizeof *threads_tried; i++) {
        struct problem problem = strip_problem(usual);
        const size_t bytes = (size_t)problem.doubles * sizeof(double);
        double *expected = malloc(bytes);
        struct described described;
        long last;
        problem_describe(&problem, &described);
        described.loop.flags &= ~(unsigned)REDCC_VERIFIABLE; /* no plan is kept */
        for (int execution = 0; execution < EXECUTIONS; execution++) {
            change(&problem, execution);
            problem_reset(&problem);
            problem_oracle(&problem);
            memcpy(expected, problem.first, bytes);
            problem_reset(&problem);
            const int threads = execution == EXECUTIONS - 1 ? 2 : threads_tried[i];
            assert_true(problem_run(&problem, &described, threads, &last));
            assert_memory_equal(expected, problem.first, bytes);
            const struct loop_state *state = redcc_made_state_of(&described.loop);
            const double share = state->execution.inspection.partition.share;
            assert_true(execution == 3 ? share == 0 : execution > 3 || (share > 0 && share < 1));
        }
        redcc_loop_forget(&described.loop);
        assert_int_equal(redcc_memory_live(), 0);
        free(expected);
        problem_free(&problem);
    }
}

static void memory_fails_anywhere(void **unused) {
    (void)unused;
    struct problem problem = strip_problem(usual);
    const size_t bytes = (size_t)problem.doubles * sizeof(double);
    double *expected = results_of(&problem, bytes);
    bool failed = true;
    for (long failures = 0; failed; failures++) {
        struct described described;
        long last;
        problem_describe(&problem, &described);
        problem_reset(&problem);
        redcc_memory_fail_after(failures);
        const int parallel = problem_run(&problem, &described, 3, &last);
        failed = redcc_memory_is_exhausted();
        redcc_memory_fail_after(-1);
        assert_true(failed || parallel);
        assert_memory_equal(expected, problem.first, bytes);
        redcc_loop_forget(&described.loop);
        assert_int_equal(redcc_memory_live(), 0);
    }
    free(expected);
    problem_free(&problem);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(borders_belong_to_those_beside_them),
        cmocka_unit_test(blocks_are_of_whole_rows),
        cmocka_unit_test(owners_move_with_the_arrays),
        cmocka_unit_test(a_cut_is_one_of_the_best),
        cmocka_unit_test(some_have_none),
        cmocka_unit_test(borders_are_smooth),
        cmocka_unit_test(same_bits_for_any_owners),
        cmocka_unit_test(samples_have_all_columns),
        cmocka_unit_test(owners_are_kept),
        cmocka_unit_test(memory_fails_anywhere),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
