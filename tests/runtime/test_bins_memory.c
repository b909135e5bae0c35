/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Binning when memory is lacking, at the beginning and in the middle of a loop. */
#include "base/memory.h"
#include "binned_work.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct bins_tuning usual;

static void memory_does_not_suffice(void **unused) {
    (void)unused;
    /* some iterations have more records than the others */
    for (int heavy = 0; heavy < 3; heavy++) {
        struct work w = work_new(77, 2);
        const int all = w.start[TRIP];
        for (int t = TRIP / 2; heavy && t <= TRIP; t++)
            w.start[t] = t < TRIP / 2 + 2 * heavy ? w.start[t] : all;
        redcc_bins_tuning.least_budget = 400 * 1024;
        assert_true(work_compare(&w, 2));
        assert_true(work_compare(&w, 3) || heavy);
        redcc_bins_tuning.least_budget = 1024;
        redcc_bins_drop((struct binning *)&work_state()->binning);
        assert_false(work_compare(&w, 2));
        assert_int_equal(work_fallbacks(REASON_NO_MEMORY) > 0, 1);
        redcc_bins_tuning = usual;
        work_free(&w);
    }
}

/* One iteration has half of all records, more than a round's blocks can hold. */
static void records_are_many_all_at_once(void **unused) {
    (void)unused;
    struct work w = work_new(78, 15);
    const int heavy = TRIP / 2 + 37; /* an iteration that is not measured */
    for (int t = heavy + 1; t < TRIP; t++)
        w.start[t] = w.start[TRIP];
    for (int threads = 1; threads <= 3; threads++) {
        redcc_bins_tuning.round = 200;
        redcc_bins_tuning.least_budget = (size_t)8 << 20;
        assert_true(work_compare(&w, threads));
        assert_int_equal(work_state()->binning.reason, REASON_NONE);
        /* with several threads, the blocks allocated after a failed round suffice */
        assert_true(work_state()->binning.rounds >= TRIP / 200 + (threads == 1));
        /* not enough for the heavy iteration */
        redcc_bins_tuning.least_budget = (size_t)threads * 200000;
        redcc_loop_forget(&work_loop.loop);
        assert_true(work_compare(&w, threads));
        assert_int_equal(work_state()->binning.reason, REASON_NO_MEMORY);
        assert_in_range(work_state()->binning.round.begin, 1, heavy);
        redcc_loop_forget(&work_loop.loop);
    }
    redcc_bins_tuning = usual;
    work_free(&w);
}

static void failing_memory(void **unused) {
    (void)unused;
    struct work w = work_new(5, 3);
    redcc_bins_tuning.round = 900;
    for (int threads = 1; threads <= 3; threads++) {
        long failures = 0;
        for (bool failed = true; failed; failures++) {
            redcc_memory_fail_after(failures);
            const bool done = work_compare(&w, threads);
            failed = redcc_memory_is_exhausted();
            redcc_memory_fail_after(-1);
            assert_true(failed || done);
            assert_true(work_compare(&w, threads)); /* repeats the loop with memory */
            redcc_loop_forget(&work_loop.loop);
            assert_int_equal(redcc_memory_live(), 0);
        }
        assert_true(failures > 20);
    }
    redcc_bins_tuning = usual;
    redcc_memory_limit(100000);
    assert_false(work_compare(&w, 2));
    assert_true(redcc_memory_in_use() <= 100000);
    assert_int_equal(work_fallbacks(REASON_NO_MEMORY), 1);
    redcc_memory_limit(8 << 20);
    assert_true(work_compare(&w, 2));
    assert_true(redcc_memory_in_use() <= 8 << 20);
    redcc_memory_limit(0);
    work_free(&w);
}

/* Memory for new bins is lacking after the first rounds: the rows change in the middle of the
 * loop. */
static void memory_fails_in_the_middle(void **unused) {
    (void)unused;
    for (long failure = 0; failure < 12; failure++) {
        struct work w = work_new(31, 3);
        redcc_bins_tuning.round = 500;
        redcc_bins_tuning.bin_bits = 8;
        assert_true(work_compare(&w, 2));
        for (int n = 0; n < w.start[TRIP]; n++)
            w.j[n] = n < w.start[TRIP / 2] ? w.j[n] / 4 : w.j[n];
        redcc_loop_forget(&work_loop.loop);
        for (int n = 0; n < w.start[TRIP]; n++)
            w.j[n] = w.j[n] / 2;
        assert_true(work_compare(&w, 2));
        for (int n = w.start[TRIP / 2]; n < w.start[TRIP]; n++)
            w.j[n] = ROWS - 2 - w.j[n];
        redcc_memory_fail_after(failure + 14);
        work_compare(&w, 2);
        redcc_memory_fail_after(-1);
        assert_true(work_state()->binning.rounds > 0);
        work_free(&w);
    }
    redcc_bins_tuning = usual;
}

int main(void) {
    usual = redcc_bins_tuning;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(memory_does_not_suffice),
        cmocka_unit_test(records_are_many_all_at_once),
        cmocka_unit_test(failing_memory),
        cmocka_unit_test(memory_fails_in_the_middle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
