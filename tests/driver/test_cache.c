/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Parts of the cache of translations: the digest, the names of headers in a text, and the data kept
 * about a project's files. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "driver/digest.h"
#include "driver/include_names.h"
#include "driver/project_text.h"

/* Digests of strings of `a`, as b2sum -l 256 prints them. */
static void digests_are_those_of_the_standard(void **state) {
    (void)state;
    static const struct {
        size_t length;
        const char *expected;
    } cases[] = {
        {0, "0e5751c026e543b2e8ab2eb06099daa1d1e5df47778f7787faab45cdf12fe3a8"},
        {3, "c8ed3cbe4acb99aeb94515ad89a6228f3f5d8f82dec429df135adafcea639416"},
        {128, "ae2aa48507885c4c950fb809b2076f959cde9f8ea6da260d9a3587df33dac450"},
        {129, "2f64744a6de0d2c0b56e64cf6e29a5aaa255010d415d51c75ccc82f73dccd865"},
    };
    char text[129];
    memset(text, 'a', sizeof text);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (size_t first = 0; first <= cases[i].length; first += 43) {
            digester d = digest_begin();
            digest_add(&d, text, first);
            digest_add(&d, text + first, cases[i].length - first);
            const digest made = digest_end(&d);
            char shown[65];
            for (unsigned k = 0; k < sizeof made.bytes; k++)
                snprintf(shown + 2 * k, 3, "%02x", made.bytes[k]);
            assert_string_equal(shown, cases[i].expected);
        }
}

static void texts_do_not_run_into_each_other(void **state) {
    (void)state;
    digester one = digest_begin(), other = digest_begin(), none = digest_begin(), empty = none;
    digest_text(&one, "ab");
    digest_text(&one, "c");
    digest_text(&other, "a");
    digest_text(&other, "bc");
    digest_text(&none, NULL);
    digest_text(&empty, "");
    const digest left = digest_end(&one), right = digest_end(&other);
    assert_memory_not_equal(&left, &right, sizeof left);
    const digest of_none = digest_end(&none), of_empty = digest_end(&empty);
    assert_memory_not_equal(&of_none, &of_empty, sizeof of_none);
}

/* Returns the header names found, as they are written, and "?" if the text does not show all
 * names. */
static const char *found(arena *a, const char *text) {
    include_names names = {0};
    buffer list = {0};
    buffer_text(&list, "");
    if (include_names_find(a, text, strlen(text), &names))
        buffer_text(&list, "?");
    for (unsigned i = 0; i < names.quoted.count; i++)
        buffer_format(&list, "\"%s\"", names.quoted.items[i]);
    for (unsigned i = 0; i < names.angled.count; i++)
        buffer_format(&list, "<%s>", names.angled.items[i]);
    for (unsigned i = 0; i < names.macros.count; i++)
        buffer_format(&list, "{%s}", names.macros.items[i]);
    const char *copy = arena_string(a, list.data);
    buffer_free(&list);
    return copy;
}

static void names_are_found_in_every_spelling(void **state) {
    (void)state;
    static const char *const cases[][2] = {
        {"", ""},
        {"#include <a.h>\n", "<a.h>"},
        {"#include \"a.h\"\n#include_next <b.h>", "\"a.h\"<b.h>"},
        {"  #\t import\v\"a b.h\"", "\"a b.h\""},
        {"\xEF\xBB\xBF#include <a.h>", "<a.h>"},
        {"x\r#include <a.h>\r\n", "<a.h>"},
        {"%: include <a.h>", "<a.h>"},
        {"/* */ # /* */ include /* x */ <a.h>", "<a.h>"},
        {"#\\\ninc\\ \t\r\nlude\\\n <a\\\n.h>", "<a.h>"},
        {"/* see #include below, include MACRO */ int include = 1;", ""},
        {"#if __has_include(<a.h>) && __has_include_next ( \"b.h\" )", "\"b.h\"<a.h>"},
        {"#ifdef __has_include\n#if defined(__has_include)", ""},
        {"/*\n   #include's protect themselves */", ""},
        {"#include MACRO", "{MACRO}"},
        {"#include MAKE(x)", "{MAKE}"},
        {"#include _MACRO", "?{_MACRO}"},
        {"#include linux", "?{linux}"},
        {"#include M$", "?"},
        {"#define HAS(x) __has_include(x)", "?{x}"},
        {"#if __has_include(NAME)", "{NAME}"},
        {"#include <a.h", "?"},
        {"?\?=include <a.h>", "?"},
        {"inc?\?/\nlude", "?"},
        {"char t[] = __TIME__;", "?"},
        {"char t[] = __DA\\\nTE__;", "?"},
        {"char my__TIME__;", ""},
        {"#embed <a.bin>", "?"},
    };
    arena *a = arena_new();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_string_equal(found(a, cases[i][0]), cases[i][1]);
    include_names names = {0};
    assert_non_null(include_names_find(a, "a\0b", 3, &names));
    arena_free(a);
}

static void macros_that_are_only_asked_for(void **state) {
    (void)state;
    assert_false(include_names_may_define("#if defined( X )\n#include X\n#undef X\n#ifdef X", "X"));
    assert_false(include_names_may_define("#define XY 1\n#define YX 1", "X"));
    assert_true(include_names_may_define("#define X \"x.h\"", "X"));
    assert_true(include_names_may_define("#define /* */ X \"x.h\"", "X"));
    assert_true(include_names_may_define("#include Y\n#define Y X", "X"));
}

static const char *write_file(arena *a, const char *folder, const char *name, const char *text) {
    const char *path = arena_format(a, "%s/%s", folder, name);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_true(fputs(text, file) >= 0 && fclose(file) == 0);
    return path;
}

static void a_project_is_the_same_when_read_again(void **state) {
    (void)state;
    arena *a = arena_new();
    char folder[] = "/tmp/redcc-project-XXXXXX";
    assert_non_null(mkdtemp(folder));
    const char *one = write_file(a, folder, "one.c",
                                 "static int own(int i) { return i; }\n"
                                 "void loop(int n, int *h) { for (int i = 0; i < n; i++) "
                                 "h[where(i)] += own(i); }\n");
    const char *two = write_file(a, folder, "two.c", "int where(int i) { return i; }\n");
    const char *none = write_file(a, folder, "three.c", "");
    const word_list list = project_list(a, two);
    assert_int_equal(list.count, 3);
    const project_scan files = project_scan_files(a, &list);
    const store_part part = project_write(a, &files);
    const project_scan again = project_read(a, &part);
    const store_part second = project_write(a, &again);
    assert_int_equal(second.length, part.length);
    assert_memory_equal(second.bytes, part.bytes, part.length);
    const project *p = project_from(a, two, &again);
    assert_true(project_calls_in_loop(p, "where"));
    assert_true(project_calls_in_loop(p, "own"));
    assert_false(project_calls_in_loop(p, "loop"));
    assert_string_equal(project_definer(project_from(a, one, &again), "where", NULL), p->own);
    const digest from_files = project_digest(project_from(a, one, &files));
    const digest from_text = project_digest(project_from(a, one, &again));
    assert_memory_equal(&from_files, &from_text, sizeof from_files);
    const project_scan empty = {0};
    const store_part nothing = project_write(a, &empty);
    assert_int_equal(project_read(a, &nothing).count, 0);
    assert_true(unlink(one) == 0 && unlink(two) == 0 && unlink(none) == 0 && rmdir(folder) == 0);
    arena_free(a);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(digests_are_those_of_the_standard),
        cmocka_unit_test(texts_do_not_run_into_each_other),
        cmocka_unit_test(names_are_found_in_every_spelling),
        cmocka_unit_test(macros_that_are_only_asked_for),
        cmocka_unit_test(a_project_is_the_same_when_read_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
