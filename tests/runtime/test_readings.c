/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Subscripts whose ranges overlap, such as row_start[i] and row_start[i + 1], or two fields of a
 * record. Each byte is read once, and no change of a byte in one of the ranges is missed. */
#include "reuse/kept.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>

#include <cmocka.h>

enum { BYTES = 1024, SOURCES = 3 };

static char data[BYTES];
static const redcc_source sources[SOURCES] = {
    {.flags = REDCC_IS_SUBSCRIPT}, {.flags = 0}, {.flags = REDCC_IS_SUBSCRIPT}};
static const redcc_loop loop = {
    .flags = REDCC_VERIFIABLE, .source_count = SOURCES, .sources = sources};

/* Sets two subscript ranges, and another read between them in the list. */
static void set_known(redcc_extent *known, int first, int end, int other_first, int other_end) {
    known[0] = (redcc_extent){data + first, data + end};
    known[1] = (redcc_extent){data, data + BYTES};
    known[2] = (redcc_extent){data + other_first, data + other_end};
}

static struct fingerprint all_of(const redcc_extent *known) {
    struct fingerprint all;
    assert_true(redcc_reuse_fingerprint(&loop, known, INFINITY, &all));
    return all;
}

static void bytes_are_read_once(void **unused) {
    (void)unused;
    static const struct {
        int first, end;
        size_t left; /* bytes to read outside [256, 512), or all bytes */
    } other[] = {{256, 512, 0},   {257, 512, 0}, {256, 513, 1},  {300, 612, 100},
                 {100, 300, 156}, {0, 256, 256}, {512, 600, 88}, {100, 600, 500}};
    for (size_t i = 0; i < sizeof other / sizeof *other; i++) {
        redcc_extent known[SOURCES];
        set_known(known, 256, 512, other[i].first, other[i].end);
        const struct reading first = redcc_reading_of(&loop, known, NULL, 0);
        const struct reading rest = redcc_reading_of(&loop, known, NULL, 2);
        assert_int_equal(redcc_range_size(first.range), 256);
        assert_int_equal(redcc_range_size(rest.range), other[i].left);
    }
}

static void every_change_is_seen(void **unused) {
    (void)unused;
    redcc_extent known[SOURCES];
    set_known(known, 256, 512, 300, 612);
    const struct fingerprint before = all_of(known);
    for (int byte = 0; byte < BYTES; byte++) {
        data[byte]++;
        assert_int_equal(redcc_fingerprint_equal(before, all_of(known)), byte < 256 || byte >= 612);
        data[byte]--;
    }
    assert_true(redcc_fingerprint_equal(before, all_of(known)));
}

/* The bytes are the same, but the second subscript begins elsewhere. */
static void another_distance_is_seen(void **unused) {
    (void)unused;
    redcc_extent known[SOURCES];
    set_known(known, 256, 512, 300, 512);
    const struct fingerprint before = all_of(known);
    set_known(known, 256, 512, 299, 512);
    assert_false(redcc_fingerprint_equal(before, all_of(known)));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(bytes_are_read_once),
                                       cmocka_unit_test(every_change_is_seen),
                                       cmocka_unit_test(another_distance_is_seen)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
