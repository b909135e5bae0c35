/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Prefetches: in which iterations they are made, what the slice does then, and when they are
 * useful. */
#include "execute/ahead.h"
#include "execute/prefetch.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MOST_RUNS = 9, MOST_COUNT = 5 };

/* Lists all iterations of the runs. Returns their number. */
static int list_all(const redcc_iterations *run, int runs, redcc_int origin, redcc_int *list) {
    int count = 0;
    for (int r = 0; r < runs; r++)
        for (redcc_u32 i = 0; i < run[r].count_and_check / 2; i++)
            list[count++] = origin + run[r].begin + i;
    return count;
}

static void try_runs(int runs, int distance) {
    redcc_iterations run[MOST_RUNS];
    redcc_int list[MOST_RUNS * MOST_COUNT], origin = rand() % 1000;
    for (int r = 0; r < runs; r++)
        run[r] =
            (redcc_iterations){(redcc_u32)(rand() % 100), (redcc_u32)(rand() % (2 * MOST_COUNT))};
    const int count = list_all(run, runs, origin, list);
    const redcc_worker worker = {.origin = origin, .run = run, .run_end = run + runs};
    redcc_ahead ahead;
    redcc_ahead_library.begin(&ahead, &worker, distance);
    for (int i = 0; i < count + 2; i++) {
        const int found = redcc_ahead_step(&ahead), expected = i + distance;
        assert_int_equal(found, expected < count);
        if (found)
            assert_int_equal(ahead.k, list[expected]);
    }
}

static void the_iteration_so_far_ahead_in_the_list(void **unused) {
    (void)unused;
    for (int i = 0; i < 20000; i++)
        try_runs(rand() % (MOST_RUNS + 1), 1 + rand() % 16);
}

/* A slice called for prefetching records nothing, and its addresses need not be valid. */
static void a_slice_without_a_worker_tells_nothing(void **unused) {
    (void)unused;
    double *nowhere = (double *)((redcc_size)1 << 20);
    redcc_probe *const redcc__probe = 0;
    redcc_worker *const redcc__worker = 0;
    const redcc_u32 redcc__source_mask = 0;
    REDCC_TOUCH(0, (const char *)nowhere, 8);
    REDCC_READ(0, (const char *)nowhere, 1000000);
    REDCC_TOUCH_ROW(0, nowhere, 1000);
    REDCC_READ_ROW(0, nowhere, -1000);
    REDCC_TOUCH_SPAN(0, (const char *)nowhere, (const char *)nowhere + 100);
    REDCC_AHEAD(nowhere, 77);
}

/* Does what REDCC_KNOWN_ROW does for the first and for the last iteration. */
static redcc_progression progression_of(const void *first, const void *last, redcc_size bytes,
                                        redcc_int trip) {
    redcc_progression it = {0, 0, 0};
    redcc_progression_row(&it, first, bytes, 0, trip);
    redcc_progression_row(&it, last, bytes, 1, trip);
    return it;
}

static void assert_progression(redcc_progression it, const void *first, redcc_int step,
                               redcc_size bytes) {
    assert_int_equal(it.first, (redcc_size)first);
    assert_int_equal(it.step, step);
    assert_int_equal(it.bytes, bytes);
}

static void rows_of_iterations_lie_at_equal_distances(void **unused) {
    (void)unused;
    enum { TRIP = 10 };
    static struct {
        int node[3];
        double weight[11];
    } element[TRIP];
    static int pair[TRIP][2];
    static double wide[TRIP][40];
    const redcc_int size = sizeof *element;
    assert_progression(progression_of(pair, pair[TRIP - 1], sizeof *pair, TRIP), pair, 8, 8);
    assert_progression(progression_of(pair[TRIP - 1], pair, sizeof *pair, TRIP), pair[TRIP - 1], -8,
                       8);
    assert_progression(progression_of(pair, pair, sizeof *pair, 1), pair, 0, 8);
    assert_progression(progression_of(element, &element[TRIP - 1], 12, TRIP), element, size,
                       (redcc_size)size); /* the whole structure is prefetched */
    /* too large to prefetch */
    assert_progression(progression_of(wide, wide[TRIP - 1], 8, TRIP), wide, 320, 8);
    /* members of one structure are prefetched once, others separately */
    const redcc_progression all[] = {
        {0, 0, 0},
        progression_of(element, &element[TRIP - 1], 12, TRIP),
        progression_of(element[0].weight, element[TRIP - 1].weight, 88, TRIP),
        progression_of(pair, pair[TRIP - 1], sizeof *pair, TRIP)};
    redcc_progression found[4];
    redcc_ahead_library.rows(found, all, 4);
    assert_int_equal(found[0].first, 0);
    assert_progression(found[1], element, size, (redcc_size)size);
    assert_int_equal(found[2].first, 0);
    assert_progression(found[3], pair, 8, 8);
    redcc_progressions_prefetch(found, 4, &(redcc_ahead){5, 0, 0, 0, 0, &redcc_ahead_library});
    redcc_progressions_prefetch(
        found, 4,
        &(redcc_ahead){(redcc_int)1 << 40, 0, 0, 0, 0,
                       &redcc_ahead_library}); /* the addresses need not be valid */
}

static void only_large_arrays_that_are_written_in_place(void **unused) {
    (void)unused;
    struct offsets touched[2] = {{-(1 << 19), 0}, {5, 4}};
    struct plan plan = {.array_count = 2, .touched = touched};
    assert_false(redcc_prefetch_is_of_use(&plan, false));
    touched[1] = (struct offsets){0, (1 << 19) + 1};
    assert_true(redcc_prefetch_is_of_use(&plan, false));
    plan.copies.count = 1;
    assert_false(redcc_prefetch_is_of_use(&plan, false));
    assert_false(redcc_prefetch_is_possible(&plan));
}

/* Prefetches are of use to light iterations only if their runs have fewer than four iterations on
 * average and the updated ranges are longer than 8 MiB in total. */
static void light_iterations_in_no_order(void **unused) {
    (void)unused;
    struct offsets touched[1] = {{0, (8 << 20) + 1}};
    struct schedule schedule[2] = {{.iterations = 700, .run_count = 300},
                                   {.iterations = 899, .run_count = 100}};
    struct plan plan = {.array_count = 1, .touched = touched, .schedule = schedule, .schedules = 2};
    assert_true(redcc_prefetch_is_of_use(&plan, true));
    schedule[1].iterations++;
    assert_false(redcc_prefetch_is_of_use(&plan, true));
    assert_true(redcc_prefetch_is_of_use(&plan, false));
    schedule[1].iterations--;
    touched[0].end--;
    assert_false(redcc_prefetch_is_of_use(&plan, true));
    assert_true(redcc_prefetch_is_of_use(&plan, false));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_iteration_so_far_ahead_in_the_list),
        cmocka_unit_test(a_slice_without_a_worker_tells_nothing),
        cmocka_unit_test(rows_of_iterations_lie_at_equal_distances),
        cmocka_unit_test(only_large_arrays_that_are_written_in_place),
        cmocka_unit_test(light_iterations_in_no_order),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
