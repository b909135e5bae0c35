/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* In which manner executions are made: what is tried, what is kept; and how many lanes there are
 * for which settings. */
#include "execute/run.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { ALL = WITH_PREFETCH | WITH_LANES };

/* Of `executions` how many were made in each manner, where they take seconds[manner]. */
static void execute(struct manners *it, unsigned open, int executions,
                    const double seconds[MANNERS], int made[MANNERS]) {
    memset(made, 0, MANNERS * sizeof *made);
    for (int i = 0; i < executions; i++) {
        const unsigned manner = redcc_manner_begins(it, open);
        made[manner]++;
        redcc_manner_note(it, open, ALL, manner, seconds[manner] * (1 + 0.5 * (i % 3 == 0)));
    }
}

static void nothing_is_tried_where_nothing_is_open(void **unused) {
    (void)unused;
    struct manners it = {0};
    int made[MANNERS];
    execute(&it, 0, 50, (const double[]){1, 1, 1, 1}, made);
    assert_int_equal(made[0], 50);
}

static void the_faster_of_two_is_kept(void **unused) {
    (void)unused;
    const double gains[] = {1.0, 0.9, 0, 0}, loses[] = {0.9, 1.0, 0, 0};
    struct manners it = {0}, other = {0};
    int made[MANNERS];
    assert_int_equal(redcc_manner_begins(&it, WITH_PREFETCH), WITH_PREFETCH);
    execute(&it, WITH_PREFETCH, 6, gains, made);
    assert_int_equal(made[WITH_PREFETCH], 3);
    execute(&it, WITH_PREFETCH, 64, gains, made);
    assert_int_equal(made[WITH_PREFETCH], 64);
    execute(&it, WITH_PREFETCH, 6, loses, made); /* the data changed */
    assert_int_equal(made[WITH_PREFETCH], 3);
    execute(&it, WITH_PREFETCH, 128, loses, made);
    assert_int_equal(made[WITH_PREFETCH], 0);
    execute(&other, WITH_PREFETCH, 6 + 64 + 6 + 128 + 6, loses, made);
    assert_int_equal(made[WITH_PREFETCH], 9);
}

static void the_fastest_of_four_is_kept(void **unused) {
    (void)unused;
    int made[MANNERS];
    for (unsigned best = 0; best < MANNERS; best++) {
        double seconds[MANNERS] = {1.0, 1.1, 1.2, 1.3};
        struct manners it = {0};
        seconds[best] = 0.9;
        assert_int_equal(redcc_manner_begins(&it, ALL), ALL);
        execute(&it, ALL, 12, seconds, made);
        for (unsigned manner = 0; manner < MANNERS; manner++)
            assert_int_equal(made[manner], 3);
        execute(&it, ALL, 64, seconds, made);
        assert_int_equal(made[best], 64);
    }
}

static void two_rounds_do_where_the_best_is_evident(void **unused) {
    (void)unused;
    int made[MANNERS];
    for (unsigned best = 0; best < MANNERS; best++) {
        double seconds[MANNERS] = {1.0, 1.0, 1.0, 1.0};
        struct manners it = {0}, close = {0};
        seconds[best] = 0.4;
        execute(&it, ALL, 8, seconds, made);
        for (unsigned manner = 0; manner < MANNERS; manner++)
            assert_int_equal(made[manner], 2);
        execute(&it, ALL, 64, seconds, made);
        assert_int_equal(made[best], 64);
        seconds[best] = 0.7;
        execute(&close, ALL, 12, seconds, made);
        assert_int_equal(made[best], 3);
    }
}

/* Prefetches of small arrays are none: what was timed with and without is one. */
static void what_makes_no_difference_is_not_tried(void **unused) {
    (void)unused;
    struct manners it = {0};
    int with_prefetch = 0, with_lanes = 0;
    for (int i = 0; i < 1 + 4 + 64; i++) {
        const unsigned manner = redcc_manner_begins(&it, ALL);
        with_prefetch += (manner & WITH_PREFETCH) != 0;
        with_lanes += (manner & WITH_LANES) != 0;
        redcc_manner_note(&it, ALL, WITH_LANES, manner, manner & WITH_LANES ? 2.0 : 1.0);
    }
    assert_int_equal(with_prefetch, 1);
    assert_int_equal(with_lanes, 1 + 2);
}

/* Does an execution prefetch, whose first plan comes in runs of `length` iterations? */
static bool prefetches(unsigned flags, enum prefetch_setting setting, int length) {
    struct offsets touched[1] = {{0, 1 << 24}};
    struct schedule schedule[1] = {{.iterations = 100 * length, .run_count = 100}};
    struct plan plan = {.array_count = 1, .touched = touched, .schedule = schedule, .schedules = 1};
    const redcc_loop loop = {.flags = flags};
    const struct call call = {.request = {.loop = &loop}, .prefetch = (int)setting};
    struct run run = {.call = &call, .plan = &plan};
    struct manners known = {0};
    redcc_run_choose_manner(&run, &known);
    return redcc_run_manner(&run, &plan).prefetches;
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

static const unsigned all_widths = REDCC_LANES_UNIT * (2 + 4 + 8);

static void expect(unsigned flags, enum lanes_setting setting, int width, enum lanes_reason why) {
    enum lanes_reason found;
    assert_int_equal(redcc_lanes_width(flags, setting, &found), width);
    assert_int_equal(found, why);
}

static void widths_that_are_asked_for(void **unused) {
    (void)unused;
    const unsigned anywhere = REDCC_LANES_ANYWHERE;
    expect(REDCC_PREFETCHES, LANES_AUTO, 0, LANES_NOT_WRITTEN);
    expect(all_widths | anywhere, LANES_OFF, 0, LANES_SAID_OFF);
    expect(all_widths | anywhere, LANES_AUTO, 8, LANES_TRYING);
    expect(all_widths | anywhere, LANES_TWO, 2, LANES_SAID);
    expect(all_widths | anywhere, LANES_FOUR, 4, LANES_SAID);
    expect(all_widths | anywhere, LANES_EIGHT, 8, LANES_SAID);
    expect(REDCC_LANES_UNIT * 4 | anywhere, LANES_EIGHT, 4, LANES_SAID);
    expect(REDCC_LANES_UNIT * 4 | anywhere, LANES_TWO, 0, LANES_NO_WIDTH);
}

static void no_width_that_the_processor_does_not_know(void **unused) {
    (void)unused;
    int most = 2;
#ifdef __x86_64__
    most = __builtin_cpu_supports("avx512f") ? 8 : __builtin_cpu_supports("avx2") ? 4 : 2;
#endif
    expect(all_widths, LANES_EIGHT, most, LANES_SAID);
    expect(all_widths, LANES_AUTO, most, LANES_TRYING);
    if (most < 8)
        expect(REDCC_LANES_UNIT * 8, LANES_AUTO, 0, LANES_NO_WIDTH);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_is_tried_where_nothing_is_open),
        cmocka_unit_test(the_faster_of_two_is_kept),
        cmocka_unit_test(the_fastest_of_four_is_kept),
        cmocka_unit_test(two_rounds_do_where_the_best_is_evident),
        cmocka_unit_test(what_makes_no_difference_is_not_tried),
        cmocka_unit_test(light_iterations_prefetch_where_they_come_in_no_order),
        cmocka_unit_test(widths_that_are_asked_for),
        cmocka_unit_test(no_width_that_the_processor_does_not_know),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
