/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Loops with sections (choose/sections.h). The number of shares depends only on sizes, and the
 * number of threads on times. Plans are reused only for the same sections. */
#include "choose/sections.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { ROOM = 4096, MEGABYTES = 100 << 20 };
static double array[ROOM];
static const redcc_array two[] = {
    {.name = "h", .operation = REDCC_SUM, .type = REDCC_DOUBLE, .element = 8, .unit = 8},
    {.name = "g", .operation = REDCC_SUM, .type = REDCC_DOUBLE, .element = 8, .unit = 8}};
static redcc_loop loop = {.array_count = 1, .arrays = two, .flags = REDCC_SHORT};
static void *bases[] = {array, array + 2000};

static redcc_extent section(size_t first, size_t count) {
    const uintptr_t at = (uintptr_t)array + first * sizeof *array;
    return (redcc_extent){(const char *)at, (const char *)(at + count * sizeof *array)};
}

static int shares(redcc_int trip, size_t count, size_t limit) {
    const redcc_extent sections[] = {section(0, count), section(2000, count)};
    return redcc_sections_shares(&loop, trip, bases, sections, limit);
}

static void shares_follow_from_sizes(void **unused) {
    (void)unused;
    assert_int_equal(shares(8191, 1, 0), 0);
    assert_int_equal(shares(8192, 1, 0), 16);
    assert_int_equal(shares(1000000, 1000001, 0), 1);
    assert_int_equal(shares(1000000, 1000000, 0), 2);
    assert_int_equal(shares(3 * 24 * 1000 - 1, 1000, 0), 2);
    assert_int_equal(shares(3 * 24 * 1000, 1000, 0), 4);
    assert_int_equal(shares(7 * 24 * 1000, 1000, 0), 8);
    assert_int_equal(shares(15 * 24 * 1000 - 1, 1000, 0), 8);
    assert_int_equal(shares(15 * 24 * 1000, 1000, 0), 16);
    assert_int_equal(shares(1000000000, MEGABYTES / 8, 0), 1); /* too large for a copy */
    assert_int_equal(shares(1000000000, MEGABYTES / 16, 0), 2);
    assert_int_equal(shares(1000000, 1000, 4 * 7 * 8000), 8); /* limited by memory */
    assert_int_equal(shares(1000000, 1000, 4 * 7 * 8000 - 4), 4);
    assert_int_equal(shares(1000000, 1000, 4 * 8000 - 4), 1);
    loop.flags = 0; /* an iteration counts as more work without REDCC_SHORT */
    assert_int_equal(shares(8192, 8 * 8192, 0), 2);
    assert_int_equal(shares(8192, 8 * 8192 + 1, 0), 1);
    assert_int_equal(shares(512, 128, 0), 2); /* few elements: the trip count may be smaller */
    assert_int_equal(shares(512, 512, 0), 2);
    assert_int_equal(shares(512, 513, 0), 0);
    assert_int_equal(shares(511, 1, 0), 0);
    loop.flags = REDCC_SHORT;
}

static void sections_must_be_apart(void **unused) {
    (void)unused;
    loop.array_count = 2;
    assert_int_equal(shares(3 * 24 * 2000, 1000, 0), 4); /* both sections count */
    assert_int_equal(shares(3 * 24 * 2000 - 1, 1000, 0), 2);
    assert_int_equal(shares(1000000, 2001, 0), 0); /* the sections overlap */
    assert_int_equal(shares(1000000, 0, 0), 0);    /* an empty section */
    redcc_extent same[] = {section(0, 1000), section(0, 1000)};
    assert_int_equal(redcc_sections_shares(&loop, 3 * 24 * 1000, bases, same, 0), 4);
    same[0].first++, same[1].first++; /* the sections do not begin at an element */
    assert_int_equal(redcc_sections_shares(&loop, 1000000, bases, same, 0), 0);
    loop.array_count = 1;
}

static void one_thread_where_it_is_faster(void **unused) {
    (void)unused;
    const redcc_int trip = 10000;
    struct sections it = {0};
    assert_int_equal(redcc_sections_threads(&it, trip, 1), 1);
    redcc_sections_timed(&it, trip, 4, 1e-8); /* the first time of each thread count is ignored */
    redcc_sections_timed(&it, trip, 1, 1);
    for (int turn = 0; turn < 2; turn++) { /* the two thread counts alternate */
        assert_int_equal(redcc_sections_threads(&it, trip, 4), turn ? 1 : 4);
        redcc_sections_timed(&it, trip, turn ? 1 : 4, turn ? 1e-5 : 1e-4);
    }
    for (int call = 1; call < 1024; call++)
        assert_int_equal(redcc_sections_threads(&it, trip, 4), 1);
    assert_int_equal(redcc_sections_threads(&it, trip, 4), 1);
    assert_int_equal(redcc_sections_threads(&it, trip, 4),
                     4); /* 4 threads are timed again after 1024 calls */
    assert_int_equal(redcc_sections_threads(&it, 100 * trip, 4), 4); /* another trip count */
}

static void long_ones_are_not_tried_alone(void **unused) {
    (void)unused;
    const redcc_int trip = 10000;
    struct sections it = {0};
    redcc_sections_timed(&it, trip, 4, 1e-5); /* the first time of each thread count is ignored */
    redcc_sections_timed(&it, trip, 1, 1e-5);
    redcc_sections_timed(&it, trip, 4, 1e-2);
    assert_int_equal(redcc_sections_threads(&it, trip, 4), 4);
    redcc_sections_timed(&it, trip, 4, 2e-2);
    assert_int_equal(redcc_sections_threads(&it, trip, 4), 4);
    redcc_sections_timed(&it, trip, 4, 1e-4);
    assert_int_equal(redcc_sections_threads(&it, trip, 4), 1);
    redcc_sections_timed(&it, trip, 1, 4e-4);
    assert_int_equal(redcc_sections_threads(&it, trip, 4), 4); /* one thread is slower */
}

static void plans_are_used_again(void **unused) {
    (void)unused;
    struct sections it = {0};
    redcc_extent sections[] = {section(100, 500), section(2100, 500)};
    loop.array_count = 2;
    struct call call = {
        .request = {.loop = &loop, .trip = 10000, .bases = bases, .sections = sections},
        .method = &redcc_method_sections,
        .parameter = 4,
        .threads = 3};
    const struct plan *plan = redcc_sections_plan(&it, &call);
    assert_non_null(plan);
    assert_int_equal(plan->copies.count, 3);
    assert_int_equal(plan->executed, 10000);
    assert_ptr_equal(redcc_sections_plan(&it, &call), plan);
    call.threads = 1; /* a further plan, with one copy */
    const struct plan *alone = redcc_sections_plan(&it, &call);
    assert_int_equal(alone->copies.count, 1);
    assert_ptr_equal(redcc_sections_plan(&it, &call), alone);
    call.threads = 3;
    assert_ptr_equal(redcc_sections_plan(&it, &call), plan);
    sections[1] = section(2100, 499);
    assert_int_equal(redcc_sections_plan(&it, &call)->touched[1].end, 599 * 8);
    sections[1] = section(2101, 498);
    assert_int_equal(redcc_sections_plan(&it, &call)->touched[1].first, 101 * 8);
    call.request.trip = 9999;
    assert_int_equal(redcc_sections_plan(&it, &call)->trip, 9999);
    call.parameter = 2;
    assert_int_equal(redcc_sections_plan(&it, &call)->copies.count, 1);
    call.threads = 2;
    assert_int_equal(redcc_sections_plan(&it, &call)->threads, 2);
    sections[1] = sections[0]; /* two arrays with one section share its copy */
    plan = redcc_sections_plan(&it, &call);
    assert_int_equal(plan->group_of[1], 0);
    assert_int_equal(plan->shift[1], 2000 * 8);
    assert_ptr_equal(redcc_sections_plan(&it, &call), plan);
    redcc_sections_end(&it);
    loop.array_count = 1;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shares_follow_from_sizes), cmocka_unit_test(sections_must_be_apart),
        cmocka_unit_test(one_thread_where_it_is_faster),
        cmocka_unit_test(long_ones_are_not_tried_alone), cmocka_unit_test(plans_are_used_again)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
