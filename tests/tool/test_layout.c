/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Long lines of generated text: where they are divided, which lines stay, and that each part
 * belongs to the user's line. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "emit/text/edit.h"
#include "emit/text/layout.h"
#include "emit/text/origin.h"

#define GUARD                                                                                      \
    "REDCC_UPDATE_ROW_WITH(0, redcc__to_forces, &redcc__to_forces[i][c], __typeof__(double[3]), "  \
    "c)"

static int setup(void **state) {
    *state = arena_new();
    return 0;
}

static int teardown(void **state) {
    arena_free(*state);
    return 0;
}

/** Lays out the user's `text`, with the edits, from column 4 of line 7 on. */
static void expect(arena *a, const char *text, edit_list *list, const char *result) {
    buffer marked = {0}, out = {0};
    origin_list origins = {0};
    assert_true(edit_apply_marked(&marked, text, 0, (uint32_t)strlen(text), list));
    layout_copy(&out, marked.data, 7, 4);
    assert_string_equal(origin_unmark(a, out.data, out.length, false, &origins), result);
    for (unsigned i = 0; i < origins.items.count;
         i++) { /* each copy is of the bytes that it names */
        const origin *copy = &origins.items.items[i];
        assert_int_equal(copy->kind, ORIGIN_COPY);
        assert_memory_equal(result + copy->begin, text + copy->from, copy->end - copy->begin);
    }
    buffer_free(&marked);
    buffer_free(&out);
}

static void test_short_lines_stay(void **state) {
    edit_list list = {0};
    edit_insert(*state, &list, 2, "{ REDCC_UPDATE(0, &h[k]) ");
    edit_insert(*state, &list, 9, " }");
    expect(*state, "{ h[k]++; \n}", &list, "{ { REDCC_UPDATE(0, &h[k]) h[k]++; } \n}");
}

static void test_long_lines_of_the_user_stay(void **state) {
    char text[160];
    memset(text, 'x', sizeof text);
    memcpy(text + 40, " + ", 3);
    text[sizeof text - 1] = 0;
    expect(*state, text, &(edit_list){0}, text);
}

static void test_guard_gets_a_line(void **state) {
    edit_list list = {0};
    edit_insert(*state, &list, 6, "{ " GUARD " ");
    edit_insert(*state, &list, 24, " }");
    expect(*state, "{\n    forces[i][c] += 1; // what\n    y++;\n}", &list,
           "{\n    { " GUARD "\n#line 8\n    forces[i][c] += 1; } // what\n    y++;\n}");
}

static void test_call_is_broken_at_its_outermost_commas(void **state) {
    edit_list list = {0};
    edit_insert(*state, &list, 0,
                "REDCC_UPDATE_BY(0, 0, 0, redcc__to_forces, &redcc__to_forces[i], record_of_two, "
                "REDCC_VALUES_2(x[i], x[j])) ");
    expect(*state, "f += 1;", &list,
           "REDCC_UPDATE_BY(0, 0, 0, redcc__to_forces, &redcc__to_forces[i], record_of_two,\n"
           "        REDCC_VALUES_2(x[i], x[j]))\n#line 7\n    f += 1;");
}

static void test_inserted_statements_get_lines(void **state) {
    edit_list list = {0};
    edit_replace(*state, &list, 0, 7, "{ int redcc__v = 1; s[0] = redcc__v; }");
    expect(*state, "s[0]++;\nx++;", &list,
           "{ int redcc__v = 1;\n#line 7\n    s[0] = redcc__v; }\nx++;");
}

static void test_no_directive_in_parentheses_literals_and_spliced_lines(void **state) {
    edit_list list = {0};
    edit_insert(*state, &list, 3, GUARD " ");
    expect(*state, "a(\n1, \"; {\\\" } \", x); /* ; (\n*/ b; \\\nc;", &list,
           "a(\n" GUARD " 1,\n    \"; {\\\" } \", x); /* ; (\n*/ b; \\\nc;");
}

static void test_directives_that_number_lines_stay(void **state) {
    edit_list list = {0};
    edit_insert(*state, &list, 0, "{ " GUARD " " GUARD " ");
    expect(*state, "x;\n# 40\ny;", &list, "{ " GUARD " " GUARD " x;\n# 40\ny;");
}

static void test_directive(void **state) {
    buffer out = {0};
    (void)state;
    layout_directive(
        &out, "#pragma omp parallel for schedule(static) private(first_of_all, second_of_all) "
              "if(say(\"one hundred, two\")) shared(x, y)");
    assert_string_equal(out.data,
                        "#pragma omp parallel for schedule(static) private(first_of_all, "
                        "second_of_all) \\\n    if(say(\"one hundred, two\")) shared(x, y)\n");
    buffer_free(&out);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_short_lines_stay, setup, teardown),
        cmocka_unit_test_setup_teardown(test_long_lines_of_the_user_stay, setup, teardown),
        cmocka_unit_test_setup_teardown(test_guard_gets_a_line, setup, teardown),
        cmocka_unit_test_setup_teardown(test_call_is_broken_at_its_outermost_commas, setup,
                                        teardown),
        cmocka_unit_test_setup_teardown(test_inserted_statements_get_lines, setup, teardown),
        cmocka_unit_test_setup_teardown(test_no_directive_in_parentheses_literals_and_spliced_lines,
                                        setup, teardown),
        cmocka_unit_test_setup_teardown(test_directives_that_number_lines_stay, setup, teardown),
        cmocka_unit_test_setup_teardown(test_directive, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
