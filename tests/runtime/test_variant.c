/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Variants of executions: which ones are tried, and which one is kept. Also the number of lanes for
 * given settings. */
#include "execute/run.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* Makes `executions` executions of this many iterations per thread. Sets made[] to the numbers of
 * slices executed without prefetches, [0], and with them, [1]. An iteration takes seconds[0]
 * without and seconds[1] with prefetches; every third slice takes half as long again. */
static void execute(struct variants *it, bool open, int executions, redcc_int iterations,
                    const double seconds[VARIANTS], int made[VARIANTS]) {
    memset(made, 0, VARIANTS * sizeof *made);
    for (int i = 0; i < executions; i++) {
        const unsigned parts = redcc_variant_parts(it, open, iterations);
        double each[VARIANT_PARTS];
        assert_in_range(parts, 0, VARIANT_PARTS);
        for (unsigned part = 0; part < parts; part++) {
            const bool variant = redcc_variant_of(it, open, part);
            made[variant]++;
            each[part] = seconds[variant] * (1 + 0.5 * (((unsigned)i + part) % 3 == 0));
        }
        if (parts == 0)
            made[redcc_variant_of(it, open, 0)]++;
        redcc_variant_note(it, open, parts, each);
    }
}

enum { SHORT = 100, LONG = 1 << 20 };

static void nothing_is_tried_where_nothing_is_open(void **unused) {
    (void)unused;
    struct variants it = {0};
    int made[VARIANTS];
    assert_int_equal(redcc_variant_parts(&it, false, LONG), 0);
    execute(&it, false, 50, LONG, (const double[VARIANTS]){1, 1}, made);
    assert_int_equal(made[0], 50);
}

/* Each short execution is one slice. */
static void the_faster_one_is_kept(void **unused) {
    (void)unused;
    const double gains[VARIANTS] = {1.0, 0.9}, loses[VARIANTS] = {0.9, 1.0};
    struct variants it = {0}, other = {0};
    int made[VARIANTS];
    assert_true(redcc_variant_of(&it, true, 0));
    execute(&it, true, 6, SHORT, gains, made);
    assert_int_equal(made[true], 3);
    execute(&it, true, 64, SHORT, gains, made);
    assert_int_equal(made[true], 64);
    execute(&it, true, 6, SHORT, loses, made); /* now the data have changed */
    assert_int_equal(made[true], 3);
    execute(&it, true, 128, SHORT, loses, made);
    assert_int_equal(made[true], 0);
    execute(&other, true, 6 + 64 + 6 + 128 + 6, SHORT, loses, made);
    assert_int_equal(made[true], 9);
}

static void one_long_execution_does_for_a_trial(void **unused) {
    (void)unused;
    int made[VARIANTS];
    for (unsigned best = 0; best < VARIANTS; best++) {
        double seconds[VARIANTS] = {1.0, 1.1};
        struct variants it = {0};
        seconds[best] = 0.9;
        execute(&it, true, 1, LONG, seconds, made);
        for (unsigned variant = 0; variant < VARIANTS; variant++)
            assert_int_equal(made[variant], VARIANT_ROUNDS);
        execute(&it, true, 64, LONG, seconds, made);
        assert_int_equal(made[best], 64);
        execute(&it, true, 1, LONG, seconds, made);
        assert_int_equal(made[best], VARIANT_ROUNDS);
    }
}

/* With five slices per execution, three rounds take two executions. */
static void executions_in_between_have_some_parts(void **unused) {
    (void)unused;
    const double close[VARIANTS] = {1.0, 1.1}, clear[VARIANTS] = {3.0, 1.0};
    struct variants it = {0}, other = {0};
    int made[VARIANTS];
    assert_int_equal(redcc_variant_parts(&it, true, 5 * 512 + 511), 5);
    execute(&it, true, 2, 5 * 512, close, made);
    assert_int_equal(made[0] + made[1], 10);
    assert_int_equal(redcc_variant_parts(&it, true, 5 * 512), 0);
    execute(&other, true, 1, 5 * 512, clear, made);
    assert_int_equal(redcc_variant_parts(&other, true, 5 * 512), 0);
    assert_true(redcc_variant_of(&other, true, 0));
}

/* Returns the variant that one execution finds best, with slices that become slower or with one
 * interruption. */
static bool best_where(bool best, double drift, unsigned interrupted) {
    struct variants it = {0};
    double each[VARIANT_PARTS];
    assert_int_equal(redcc_variant_parts(&it, true, LONG), VARIANT_PARTS);
    for (unsigned part = 0; part < VARIANT_PARTS; part++)
        each[part] = (redcc_variant_of(&it, true, part) == best ? 0.9 : 1.0) + drift * part +
                     10 * (part == interrupted);
    redcc_variant_note(&it, true, VARIANT_PARTS, each);
    return redcc_variant_of(&it, true, 0);
}

static void neither_order_nor_one_part_decides(void **unused) {
    (void)unused;
    for (int best = 0; best < VARIANTS; best++) {
        assert_int_equal(best_where(best, 0.05, VARIANT_PARTS), best);
        for (unsigned interrupted = 0; interrupted < VARIANT_PARTS; interrupted++)
            assert_int_equal(best_where(best, 0, interrupted), best);
    }
}

static void two_rounds_do_where_the_best_is_evident(void **unused) {
    (void)unused;
    int made[VARIANTS];
    for (int best = 0; best < VARIANTS; best++) {
        double seconds[VARIANTS] = {1.0, 1.0};
        struct variants it = {0}, close = {0};
        seconds[best] = 0.3;
        execute(&it, true, 4, SHORT, seconds, made);
        assert_int_equal(made[0], 2);
        assert_int_equal(made[1], 2);
        execute(&it, true, 64, SHORT, seconds, made);
        assert_int_equal(made[best], 64);
        seconds[best] = 0.95;
        execute(&close, true, 6, SHORT, seconds, made);
        assert_int_equal(made[best], 3);
    }
}

/* The result is kept in executions for which prefetches make no difference. */
static void what_is_known_stays(void **unused) {
    (void)unused;
    const double seconds[VARIANTS] = {1.0, 0.5};
    struct variants it = {0};
    int made[VARIANTS];
    execute(&it, true, 1, LONG, seconds, made);
    assert_int_equal(redcc_variant_parts(&it, true, LONG), 0);
    execute(&it, false, 100, LONG, seconds, made);
    assert_int_equal(made[0], 100);
    assert_int_equal(redcc_variant_parts(&it, true, LONG), 0);
    assert_true(redcc_variant_of(&it, true, 0));
}

/* 33 iterations are executed in slices of 10: runs that are handed out are cut at the slices'
 * ends. */
static void iterations_are_cut_into_parts(void **unused) {
    (void)unused;
    struct parts it;
    double seconds[VARIANT_PARTS] = {0}, iterations[VARIANT_PARTS] = {0};
    redcc_parts_begin(&it, 4, 39);
    for (int i = 0; i < 33; i++) {
        assert_int_equal(redcc_parts_next(&it), i > 0 && i % 10 == 0);
        it.left--;
    }
    redcc_parts_end(&it);
    redcc_parts_add(&it, seconds, iterations);
    redcc_parts_add(&it, seconds, iterations);
    const double expected[] = {20, 20, 20, 6, 0};
    for (int part = 0; part < 5; part++) {
        assert_true(iterations[part] == expected[part]); /* NOLINT: whole numbers */
        assert_true(seconds[part] >= 0);
    }
    /* additional iterations belong to the last part; with too few iterations some parts are
     * empty */
    redcc_parts_begin(&it, 2, 9);
    for (int i = 0; i < 33; i++) {
        redcc_parts_next(&it);
        it.left--;
    }
    redcc_parts_end(&it);
    assert_int_equal(it.part[0].iterations, 5);
    assert_int_equal(it.part[1].iterations, 28);
    redcc_parts_begin(&it, VARIANT_PARTS, 0);
    redcc_parts_end(&it);
    memset(iterations, 0, sizeof iterations);
    redcc_parts_add(&it, seconds, iterations);
    for (int part = 0; part < VARIANT_PARTS; part++)
        assert_true(iterations[part] == 0); /* NOLINT */
    redcc_parts_begin(&it, 0, 10);
    redcc_parts_end(&it);
    redcc_parts_add(&it, seconds, iterations);
    assert_true(iterations[0] == 0); /* NOLINT */
}

/* The runs of a chunk, read in parts of each length, must contain the same iterations, with the
 * same checks. */
static void expect_all_in_parts(const struct schedule *schedule, const char *checked,
                                redcc_int trip, redcc_int length) {
    struct run_reader reader = redcc_runs_of(schedule, &schedule->chunk[0]);
    redcc_iterations run[3];
    redcc_int at = 0;
    for (redcc_int left = length; at < trip; left = left == 0 ? length : left) {
        const redcc_int before = left;
        const size_t count = redcc_runs_read_part(&reader, run, 3, &left);
        assert_in_range(count, 1, 3);
        redcc_int read = 0;
        for (size_t r = 0; r < count; r++)
            for (redcc_u32 i = 0; i < run[r].count_and_check / 2; i++, read++) {
                assert_int_equal(schedule->chunk[0].origin + run[r].begin + i, at);
                assert_int_equal(run[r].count_and_check & 1, checked[at++]);
            }
        assert_int_equal(before - left, read);
        assert_true(left >= 0);
    }
    redcc_int more = 1;
    assert_int_equal(redcc_runs_read_part(&reader, run, 3, &more), 0);
    assert_int_equal(more, 1);
}

static void runs_are_read_in_parts(void **unused) {
    (void)unused;
    enum { TRIP = 6000 };
    static char checked[TRIP];
    for (int longest = 2; longest <= 200; longest *= 10) { /* packed runs, and long ones */
        struct schedule schedule = {0};
        redcc_int at = 0;
        for (int r = 0; at < TRIP; r++) {
            redcc_int count = 1 + r * 7 % longest;
            count = count < TRIP - at ? count : TRIP - at;
            assert_true(redcc_schedule_add(&schedule, 0, at, count, r % 2));
            memset(checked + at, r % 2, (size_t)count);
            at += count;
        }
        redcc_schedule_finish(&schedule);
        assert_int_equal(schedule.packed != NULL, longest < 200);
        for (redcc_int length = 1; length <= TRIP; length += 1 + length / 3)
            expect_all_in_parts(&schedule, checked, TRIP, length);
        redcc_schedule_end(&schedule);
    }
}

/* Does an execution prefetch if its first plan has runs of `length` iterations? */
static bool prefetches(unsigned flags, enum prefetch_setting setting, int length) {
    struct offsets touched[1] = {{0, 1 << 24}};
    struct schedule schedule[1] = {{.iterations = 100 * length, .run_count = 100}};
    struct plan plan = {.array_count = 1,
                        .touched = touched,
                        .schedule = schedule,
                        .schedules = 1,
                        .threads = 1,
                        .executed = schedule->iterations};
    const redcc_loop loop = {.flags = flags};
    const struct call call = {.request = {.loop = &loop}, .prefetch = (int)setting};
    struct run run = {.call = &call, .plan = &plan};
    struct variants known = {0};
    redcc_run_choose_variant(&run, &known);
    return redcc_run_variant(&run, &plan, 0).prefetches;
}

static void light_iterations_prefetch_where_they_come_in_no_order(void **unused) {
    (void)unused;
    assert_true(prefetches(REDCC_LIGHT, PREFETCH_AUTO, 2));
    assert_false(prefetches(REDCC_LIGHT, PREFETCH_AUTO, 5));
    assert_true(prefetches(REDCC_LIGHT, PREFETCH_ON, 5));
    assert_false(prefetches(REDCC_LIGHT, PREFETCH_OFF, 2));
    assert_true(prefetches(REDCC_PREFETCHES, PREFETCH_AUTO, 2));
    assert_true(prefetches(REDCC_PREFETCHES, PREFETCH_AUTO, 5));
    assert_false(prefetches(0, PREFETCH_ON, 2));
}

static void expect(unsigned flags, enum lanes_setting setting, int width, enum lanes_reason why) {
    enum lanes_reason found;
    assert_int_equal(redcc_lanes_width(flags, setting, &found), width);
    assert_int_equal(found, why);
}

static void lanes_that_are_written_are_used(void **unused) {
    (void)unused;
    const unsigned anywhere = REDCC_LANES_ANYWHERE | REDCC_DRY_RUN;
    expect(REDCC_PREFETCHES | REDCC_DRY_RUN, LANES_AUTO, 0, LANES_NOT_WRITTEN);
    expect(4 * REDCC_LANES_UNIT | anywhere, LANES_OFF, 0, LANES_SAID_OFF);
    expect(4 * REDCC_LANES_UNIT | anywhere, LANES_AUTO, 4, LANES_USED);
    expect(2 * REDCC_LANES_UNIT | anywhere, LANES_AUTO, 2, LANES_USED);
}

static void none_that_the_processor_does_not_know(void **unused) {
    (void)unused;
    bool can = false;
#ifdef __x86_64__
    can = __builtin_cpu_supports("avx2");
#endif
    expect(4 * REDCC_LANES_UNIT, LANES_AUTO, can ? 4 : 0, can ? LANES_USED : LANES_NO_PROCESSOR);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_is_tried_where_nothing_is_open),
        cmocka_unit_test(the_faster_one_is_kept),
        cmocka_unit_test(one_long_execution_does_for_a_trial),
        cmocka_unit_test(executions_in_between_have_some_parts),
        cmocka_unit_test(neither_order_nor_one_part_decides),
        cmocka_unit_test(two_rounds_do_where_the_best_is_evident),
        cmocka_unit_test(what_is_known_stays),
        cmocka_unit_test(iterations_are_cut_into_parts),
        cmocka_unit_test(runs_are_read_in_parts),
        cmocka_unit_test(light_iterations_prefetch_where_they_come_in_no_order),
        cmocka_unit_test(lanes_that_are_written_are_used),
        cmocka_unit_test(none_that_the_processor_does_not_know),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
