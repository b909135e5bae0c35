/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Cases in which binning ends, or repeats a round, during a loop: reads that overlap a round's
 * writes, streams that overlap, and rows over a large range. The loops have several arrays in a
 * record, several updates of an array, and inner loops. */
#include "base/memory.h"
#include "binned_work.h"
#include "settings.h"

#include <errno.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include <cmocka.h>

static struct bins_tuning usual;

static void records_of_several_arrays_and_updates(void **unused) {
    (void)unused;
    static const int threads[] = {1, 2, 3, 7, 16, 33};
    for (int n = 0; n < 24; n++) {
        struct work w = work_new((unsigned long)n + 1, 1 + n % 7);
        redcc_bins_tuning.bin_bits = n % 4 == 0 ? 3 : 15;
        redcc_bins_tuning.least_budget = (size_t)1 << (n % 4 == 0 ? 32 : 23);
        redcc_bins_tuning.round = n % 3 ? INT64_MAX : 700;
        redcc_bins_tuning.direct_bins = n % 2 ? 0 : 4096;
        assert_true(work_compare(&w, threads[n % 6]));
        assert_true(work_compare(&w, threads[(n + 3) % 6]));
        assert_int_equal(work_state()->binning.reason,
                         REASON_NONE); /* x is next to the written rows */
        assert_int_equal(work_validated(), redcc_settings()->validate ? 2 : 0);
        work_free(&w);
    }
    redcc_bins_tuning = usual;
}

/* From iteration `from` on, the loop reads rows of x that it also writes. */
static void reads_overlap_from(redcc_int from, redcc_int round) {
    struct work w = work_new(9, 3);
    w.x = now.other + ROWS - X;
    for (int n = 0; n < w.start[TRIP]; n++)
        w.j[n] = w.j[n] % (ROWS - 2 * X);
    while (from < TRIP && w.start[from] == w.start[from + 1])
        from--;
    for (int t = (int)from; t < TRIP; t++)
        w.m[t] = w.j[w.start[t]] - (ROWS - X);
    for (int threads = 1; threads <= 7; threads += 3) {
        redcc_bins_tuning.round = round;
        const long validated = work_state() ? work_validated() : 0;
        const bool binned = work_compare(&w, threads);
        assert_int_equal(binned, from >= round);
        assert_int_equal(work_validated() - validated, binned && redcc_settings()->validate);
        assert_int_equal(work_state()->binning.reason, from < TRIP ? REASON_OVERLAP : REASON_NONE);
        assert_true(work_state()->binning.round.begin <= from);
        if (binned && from < TRIP)
            assert_true(work_state()->binning.round.begin > from - round);
        assert_string_equal(work_state()->reported.statistics.why.overlap[0].text,
                            from < TRIP ? "'x' overlaps 'other'" : "");
    }
    redcc_bins_tuning = usual;
    work_free(&w);
}

static void late_guard(void **unused) {
    (void)unused;
    reads_overlap_from(0, 1000);
    reads_overlap_from(1, 1000);
    reads_overlap_from(1, 1);
    reads_overlap_from(2500, 100);
    reads_overlap_from(TRIP - 1, 1000);
    reads_overlap_from(TRIP - 1, 1);
    reads_overlap_from(TRIP, 1000);
}

/* One row is read; rows `lowest` to `highest` are written. */
static void guard_at(int row, int lowest, int highest, bool overlaps) {
    struct work w = work_new(23, 3);
    w.x = now.other + row;
    for (int t = 0; t < TRIP; t++)
        w.m[t] = 0;
    for (int n = 0; n < w.start[TRIP]; n++)
        w.j[n] = n == 77 ? lowest : n == 99 ? highest - 1 : (lowest + highest) / 2;
    for (int threads = 1; threads <= 4; threads += 3) {
        assert_int_equal(work_compare(&w, threads), !overlaps);
        assert_int_equal(work_state()->binning.reason, overlaps ? REASON_OVERLAP : REASON_NONE);
    }
    work_free(&w);
}

static void the_guard_is_exact(void **unused) {
    (void)unused;
    for (uint32_t bits = 4; bits <= 15; bits += 11) {
        redcc_bins_tuning.bin_bits = bits;
        redcc_bins_tuning.least_budget = (size_t)1 << 32;
        guard_at(99, 100, 200, false);
        guard_at(100, 100, 200, true);
        guard_at(200, 100, 200, true);
        guard_at(201, 100, 200, false);
    }
    redcc_bins_tuning = usual;
}

/* Later rounds may write what earlier rounds have read, as in the sequential loop. */
static void reads_before_writes(void **unused) {
    (void)unused;
    struct work w = work_new(19, 3);
    w.x = now.other;
    for (int t = 0; t < TRIP; t++) {
        w.m[t] = t < TRIP / 2 ? w.m[t] : ROWS + w.m[t] % X;
        for (int n = w.start[t]; n < w.start[t + 1]; n++)
            w.j[n] = t < TRIP / 2 ? 2 * X + w.j[n] / 2 : w.j[n] / 40;
    }
    redcc_bins_tuning.round = TRIP / 4;
    for (int threads = 1; threads <= 5; threads++) {
        assert_true(work_compare(&w, threads));
        assert_int_equal(work_state()->binning.reason, REASON_NONE);
        assert_int_equal(work_state()->binning.rounds, 4);
    }
    redcc_bins_tuning = usual;
    work_free(&w);
}

static void fewer_threads_come(void **unused) {
    (void)unused;
    struct work w = work_new(29, 3);
    for (int asked = 2; asked <= 8; asked++)
        for (int given = 1; given <= asked; given += 3) {
            fewer = given;
            assert_true(work_compare(&w, asked));
            assert_int_equal(work_state()->reported.statistics.threads, given);
        }
    fewer = 0;
    work_free(&w);
}

static void streams_overlap(void **unused) {
    (void)unused;
    struct work w = work_new(4, 3);
    w.other = now.sum + 10;
    assert_false(work_compare(&w, 2));
    assert_int_equal(work_fallbacks(REASON_OUT_OF_STEP), 1);
    w.other = now.other;
    w.x = now.other + ROWS;
    w.sum = (double *)(void *)now.count; /* two arrays of one stream, at one subscript */
    w.count = now.count + 1;
    assert_false(work_compare(&w, 2));
    assert_int_equal(work_fallbacks(REASON_OUT_OF_STEP), 2);
    work_free(&w);
}

static void errors_of_functions(void **unused) {
    (void)unused;
    struct work w = work_new(6, 3);
    memcpy(&now, &before, sizeof now);
    redcc_bins_tuning.round = 1000;
    errno = ERANGE;
    assert_true(work_run(&w, 3));
    assert_int_equal(errno, ERANGE);
    w.value[w.start[TRIP / 2]] = WRONG;
    assert_true(work_run(&w, 3));
    assert_int_equal(errno, EDOM);
    redcc_bins_tuning = usual;
    work_free(&w);
}

/* The mathematical function fails for a value only until an earlier update has been applied. */
static void errors_of_rounds_thrown_away(void **unused) {
    (void)unused;
    struct work w = work_new(8, 3);
    redcc_int last = TRIP - 1;
    while (w.start[last] == w.start[last + 1])
        last--;
    for (int n = 0; n < w.start[TRIP]; n++)
        w.j[n] = n == w.start[TRIP / 2 + 10] ? 7 : 100 + w.j[n] / 2;
    w.x = now.other;
    for (int t = 0; t < TRIP; t++)
        w.m[t] = t == last ? 7 : ROWS + t % X;
    before.other[7] = WRONG;
    redcc_bins_tuning.round = TRIP / 2;
    for (int threads = 1; threads <= 3; threads++) {
        errno = ERANGE;
        assert_true(work_compare(&w, threads));
        assert_int_equal(work_state()->binning.reason, REASON_OVERLAP);
        memcpy(&now, &before, sizeof now);
        errno = ERANGE;
        assert_true(work_run(&w, threads));
        assert_int_equal(errno, ERANGE);
    }
    before.other[7] = 0;
    redcc_bins_tuning = usual;
    work_free(&w);
}

/* One row is far below the others, in sparse memory: the sequential loop runs. */
static void rows_far_apart(void **unused) {
    (void)unused;
    const size_t distance = (size_t)1 << 38, room = 1 << 16;
    char *all =
        mmap(NULL, distance + room, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    assert_ptr_not_equal(all, MAP_FAILED);
    assert_int_equal(mprotect(all, room, PROT_READ | PROT_WRITE), 0);
    assert_int_equal(mprotect(all + distance, room, PROT_READ | PROT_WRITE), 0);
    const redcc_int far = (redcc_int)(distance / sizeof(double));
    assert_int_equal(
        redcc_window(&work_loop.streams[1], (struct row_range){0, far}, 0, 2, 1, 1000).rows, 0);
    const struct row_range widest = {INT64_MIN, INT64_MAX};
    assert_int_equal(redcc_window(&work_loop.streams[1], widest, 0, 2, 1, 1000).rows, 0);
    const struct row_range many = {0, 1 << 20};
    assert_int_equal(redcc_window(&work_loop.streams[1], many, 0, 1, 1, 10).shift,
                     15); /* the stream whose records have a tag */
    struct work w = work_new(12, 1);
    w.other = (double *)(void *)all;
    w.k[0] = 0;
    for (int n = 0; n < w.start[TRIP]; n++)
        w.j[n] = w.j[n] % 100;
    assert_true(work_run(&w, 2));
    munmap(all, distance + room);
    work_free(&w);
}

static void loops_without_the_form_are_left_alone(void **unused) {
    (void)unused;
    struct work w = work_new(12, 1);
    work_loop.loop.flags &= ~(unsigned)REDCC_BINNED;
    assert_false(work_compare(&w, 2));
    assert_int_equal(work_fallbacks(REASON_NO_BINS), 1);
    work_free(&w);
    work_loop.loop.flags |= REDCC_BINNED;
}

int main(void) {
    usual = redcc_bins_tuning;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(records_of_several_arrays_and_updates),
        cmocka_unit_test(late_guard),
        cmocka_unit_test(the_guard_is_exact),
        cmocka_unit_test(reads_before_writes),
        cmocka_unit_test(fewer_threads_come),
        cmocka_unit_test(streams_overlap),
        cmocka_unit_test(errors_of_functions),
        cmocka_unit_test(errors_of_rounds_thrown_away),
        cmocka_unit_test(rows_far_apart),
        cmocka_unit_test(loops_without_the_form_are_left_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
