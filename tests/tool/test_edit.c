/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Byte edits: the order of insertions, and every kind of edit that must be refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "emit/text/edit.h"

static const char text[] = "0123456789";

static int setup(void **state) {
    *state = arena_new();
    return 0;
}

static int teardown(void **state) {
    arena_free(*state);
    return 0;
}

static void expect(edit_list *list, uint32_t begin, uint32_t end, const char *result) {
    buffer out = {0};
    assert_true(edit_apply(&out, text, begin, end, list));
    assert_string_equal(out.data ? out.data : "", result);
    buffer_free(&out);
}

static void expect_refused(edit_list *list, uint32_t begin, uint32_t end) {
    buffer out = {0};
    assert_false(edit_apply(&out, text, begin, end, list));
    assert_int_equal(out.length, 0);
    buffer_free(&out);
}

static void test_nothing_to_do(void **state) {
    (void)state;
    edit_list none = {0};
    expect(&none, 0, 10, text);
    expect(&none, 3, 5, "34");
    expect(&none, 4, 4, "");
}

static void test_replaces_in_any_order(void **state) {
    edit_list list = {0};
    edit_replace(*state, &list, 8, 10, "Z");
    edit_replace(*state, &list, 0, 1, "AA");
    edit_replace(*state, &list, 3, 5, "");
    expect(&list, 0, 10, "AA12567Z");
}

static void test_insertions_keep_their_order_and_go_first(void **state) {
    edit_list list = {0};
    edit_replace(*state, &list, 2, 4, "R");
    edit_insert(*state, &list, 2, "a");
    edit_insert(*state, &list, 2, "b");
    edit_insert(*state, &list, 4, "c");
    edit_insert(*state, &list, 10, "d");
    edit_insert(*state, &list, 0, "e");
    expect(&list, 0, 10, "e01abRc456789d");
}

static void test_many(void **state) {
    edit_list list = {0};
    for (uint32_t i = 10; i-- > 0;)
        edit_replace(*state, &list, i, i + 1, "x");
    expect(&list, 0, 10, "xxxxxxxxxx");
}

static void test_refuses_overlap(void **state) {
    edit_list list = {0};
    edit_replace(*state, &list, 2, 5, "a");
    edit_replace(*state, &list, 4, 6, "b");
    expect_refused(&list, 0, 10);
    edit_list inside = {0};
    edit_replace(*state, &inside, 2, 8, "a");
    edit_insert(*state, &inside, 5, "b");
    expect_refused(&inside, 0, 10);
    edit_list same = {0};
    edit_replace(*state, &same, 2, 4, "a");
    edit_replace(*state, &same, 2, 4, "b");
    expect_refused(&same, 0, 10);
}

static void test_refuses_what_is_outside(void **state) {
    edit_list after = {0};
    edit_replace(*state, &after, 8, 11, "a");
    expect_refused(&after, 0, 10);
    edit_list before = {0};
    edit_replace(*state, &before, 1, 2, "a");
    expect_refused(&before, 2, 10);
    edit_list backwards = {0};
    edit_replace(*state, &backwards, 5, 3, "a");
    expect_refused(&backwards, 0, 10);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_nothing_to_do, setup, teardown),
        cmocka_unit_test_setup_teardown(test_replaces_in_any_order, setup, teardown),
        cmocka_unit_test_setup_teardown(test_insertions_keep_their_order_and_go_first, setup,
                                        teardown),
        cmocka_unit_test_setup_teardown(test_many, setup, teardown),
        cmocka_unit_test_setup_teardown(test_refuses_overlap, setup, teardown),
        cmocka_unit_test_setup_teardown(test_refuses_what_is_outside, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
