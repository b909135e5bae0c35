/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Prefetches: which iteration goes before which, what is asked of a slice then, and where they are
 * of use. */
#include "execute/prefetch.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MOST_RUNS = 9, MOST_COUNT = 5 };

/* All iterations of the runs, in a list. */
static int list_all(const redcc_run *run, int runs, redcc_int origin, redcc_int *list) {
    int count = 0;
    for (int r = 0; r < runs; r++)
        for (redcc_u32 i = 0; i < run[r].count_and_guard / 2; i++)
            list[count++] = origin + run[r].begin + i;
    return count;
}

static void try_runs(int runs, int prefetches) {
    redcc_run run[MOST_RUNS];
    redcc_int list[MOST_RUNS * MOST_COUNT], origin = rand() % 1000;
    for (int r = 0; r < runs; r++)
        run[r] = (redcc_run){(redcc_u32)(rand() % 100), (redcc_u32)(rand() % (2 * MOST_COUNT))};
    const int count = list_all(run, runs, origin, list);
    const redcc_worker worker = {
        .origin = origin, .run = run, .run_end = run + runs, .manner = {prefetches, 0}};
    redcc_ahead ahead;
    redcc_ahead_begin(&ahead, &worker, worker.manner.prefetches, REDCC_PREFETCH_DISTANCE);
    for (int i = 0; i < count + 2; i++) {
        const int found = redcc_ahead_step(&ahead), expected = i + REDCC_PREFETCH_DISTANCE;
        assert_int_equal(found, prefetches && expected < count);
        if (found)
            assert_int_equal(ahead.k, list[expected]);
    }
}

static void the_iteration_two_ahead_in_the_list(void **unused) {
    (void)unused;
    for (int i = 0; i < 20000; i++)
        try_runs(rand() % (MOST_RUNS + 1), i % 5 != 0);
}

/* Nothing is told of it, and addresses need not be valid. */
static void a_slice_without_a_worker_tells_nothing(void **unused) {
    (void)unused;
    double *nowhere = (double *)((redcc_size)1 << 20);
    redcc_probe *const redcc__probe = 0;
    redcc_worker *const redcc__worker = 0;
    const redcc_u32 redcc__told = 0;
    REDCC_TOUCH(0, (const char *)nowhere, 8);
    REDCC_READ(0, (const char *)nowhere, 1000000);
    REDCC_TOUCH_ROW(0, nowhere, 1000);
    REDCC_READ_ROW(0, nowhere, -1000);
    REDCC_TOUCH_SPAN(0, (const char *)nowhere, (const char *)nowhere + 100);
    REDCC_AHEAD(nowhere, 77);
}

static void only_large_arrays_that_are_written_in_place(void **unused) {
    (void)unused;
    struct offsets touched[2] = {{-(1 << 19), 0}, {5, 4}};
    struct plan plan = {.array_count = 2, .touched = touched};
    assert_false(redcc_prefetch_is_of_use(&plan));
    touched[1] = (struct offsets){0, (1 << 19) + 1};
    assert_true(redcc_prefetch_is_of_use(&plan));
    plan.copies.count = 1;
    assert_false(redcc_prefetch_is_of_use(&plan));
    assert_false(redcc_prefetch_is_possible(&plan));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_iteration_two_ahead_in_the_list),
        cmocka_unit_test(a_slice_without_a_worker_tells_nothing),
        cmocka_unit_test(only_large_arrays_that_are_written_in_place),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
