/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The wrapper's parsing of a compiler's command line, without any compiler. */
#include <limits.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "driver/build_report.h"
#include "driver/command.h"
#include "driver/dependencies.h"
#include "driver/files.h"
#include "driver/temporary.h"

static void table_is_sorted(void **state) {
    (void)state;
    assert_non_null(option_at(0));
    for (unsigned i = 1; option_at(i); i++)
        assert_true(strcmp(option_at(i - 1)->name, option_at(i)->name) < 0);
}

static void every_entry_finds_itself(void **state) {
    (void)state;
    for (unsigned i = 0; option_at(i); i++) {
        const option *one = option_at(i);
        assert_ptr_equal(option_find(one->name), one);
        if (one->meaning & OPTION_JOINED) {
            char joined[64];
            snprintf(joined, sizeof joined, "%s\x7f", one->name);
            assert_ptr_equal(option_find(joined), one);
        }
    }
}

static void assert_finds(const char *word, const char *name) {
    const option *found = option_find(word);
    if (!name) {
        assert_null(found);
        return;
    }
    assert_non_null(found);
    assert_string_equal(found->name, name);
}

static void longest_beginning_wins(void **state) {
    (void)state;
    assert_finds("-MF", "-MF");
    assert_finds("-MFx.d", "-MF");
    assert_finds("-MMD", "-MMD");
    assert_finds("-Wp,-DA", "-Wp,-D");
    assert_finds("-Wp,-I.", "-Wp,");
    assert_finds("-Wall", NULL);
    assert_finds("-fopenmp", "-fopenmp");
    assert_finds("-fopenmp=libomp", "-fopenmp=");
    assert_finds("-include", "-include");
    assert_finds("-isystem/usr", "-isystem");
    assert_finds("-march=native", "-m");
    assert_finds("-m32", "-m32");
    assert_finds("-cx", NULL);
    assert_finds("--unheard-of", "--");
    assert_finds("-", NULL);
}

static command parse(arena *a, const char *line) {
    word_list words = {0};
    words_split(a, line, &words);
    return command_parse(a, &words, false);
}

static void kinds_of_commands(void **state) {
    arena *a = *state;
    static const struct {
        const char *line;
        bool compiles, links;
        unsigned c_count, compiled, linked;
    } cases[] = {
        {"-c a.c", true, false, 1, 1, 0},
        {"a.c b.c x.o -lm -l z", true, true, 2, 2, 3},
        {"-E a.c", false, false, 1, 1, 0},
        {"-MM a.c", false, false, 1, 1, 0},
        {"x.o -o a.c", false, true, 0, 0, 1},
        {"-x c a.o -x none b.o", true, true, 1, 1, 1},
        {"-x c++ a.c", true, true, 0, 1, 0},
        {"-xc -", true, true, 1, 1, 0},
        {"-O2 -Wall", false, false, 0, 0, 0},
        {"-S a.s b.cpp", true, false, 0, 2, 0},
        {"-I a.c -D b.c -include c.c --param d.c -MF e.c -c f.c", true, false, 1, 1, 0},
        {"libx.so.1.2 x.a", false, true, 0, 0, 2},
        {"--version a.c", false, false, 1, 1, 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        command c = parse(a, cases[i].line);
        assert_int_equal(c.compiles, cases[i].compiles);
        assert_int_equal(c.links, cases[i].links);
        assert_int_equal(c.c_count, cases[i].c_count);
        assert_int_equal(c.compiled, cases[i].compiled);
        assert_int_equal(c.linked, cases[i].linked);
    }
}

static void output_is_joined_or_apart(void **state) {
    arena *a = *state;
    assert_string_equal(parse(a, "-c a.c -o x.o").output, "x.o");
    assert_string_equal(parse(a, "-c a.c -ox.o").output, "x.o");
    assert_null(parse(a, "-c a.c").output);
    assert_null(parse(a, "-c a.c -fopenmp -openmpish").language);
}

static void splits_as_gcc_does(void **state) {
    arena *a = *state;
    word_list words = {0};
    words_split(a, " a\\ b 'c d' \"e \\\" f\"\n'' g'h'i '\\n' ", &words);
    const char *const expected[] = {"a b", "c d", "e \" f", "", "ghi", "\\n"};
    assert_int_equal(words.count, sizeof expected / sizeof expected[0]);
    for (unsigned i = 0; i < words.count; i++)
        assert_string_equal(words.items[i], expected[i]);
}

static void write_text(const char *path, const char *text) {
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

static void response_files_come_back(void **state) {
    arena *a = *state;
    const char *folder = temporary_create(a);
    assert_non_null(folder);
    const char *path = arena_format(a, "%s/words", folder);
    word_list words = {0}, back = {0};
    static const char *const strange[] = {"", "a b", "\"", "\\", "'", "new\nline", "@x", "-D'a'"};
    for (size_t i = 0; i < sizeof strange / sizeof strange[0]; i++)
        words_add(a, &words, strange[i]);
    assert_true(words_write(&words, path));
    char *given[] = {arena_format(a, "@%s", path)};
    assert_true(words_expand(a, 1, given, &back));
    assert_int_equal(back.count, words.count);
    for (unsigned i = 0; i < back.count; i++)
        assert_string_equal(back.items[i], words.items[i]);
    write_text(path, arena_format(a, "@%s", path)); /* a file that names itself must not be read
                                                     * endlessly */
    back.count = 0;
    words_expand(a, 1, given, &back);
    assert_int_equal(back.count, 1);
    temporary_remove(folder);
    assert_int_not_equal(access(folder, F_OK), 0);
}

static void reads_dependency_files(void **state) {
    arena *a = *state;
    const char *folder = temporary_create(a);
    const char *path = arena_format(a, "%s/x.d", folder);
    write_text(path, "x: a\\ b.c ./y.h \\\n  $$z.h \\\n \\#q.h w\\x.h\n\ny.h:\n");
    word_list list = {0};
    assert_true(dependencies_read(a, path, &list));
    const char *const expected[] = {"a b.c", "y.h", "$z.h", "#q.h", "w\\x.h"};
    assert_int_equal(list.count, sizeof expected / sizeof expected[0]);
    for (unsigned i = 0; i < list.count; i++)
        assert_string_equal(list.items[i], expected[i]);
    write_text(path, "");
    assert_false(dependencies_read(a, path, &list));
    assert_false(dependencies_read(a, "/no/such/file", &list));
    temporary_remove(folder);
}

static word_list split(arena *a, const char *text) {
    word_list words = {0};
    words_split(a, text, &words);
    return words;
}

static void compares_dependencies(void **state) {
    arena *a = *state;
    word_list original = split(a, "src/x.c y.h z.h");
    word_list same = split(a, "/tmp/x.c /i/redcc/runtime.h y.h z.h");
    word_list other = split(a, "/tmp/x.c /i/redcc/runtime.h src/y.h z.h");
    word_list twice = split(a, "/tmp/x.c y.h z.h y.h");
    word_list fewer = split(a, "/tmp/x.c y.h");
    assert_true(dependencies_equal(a, &original, "./src/x.c", &same, "/tmp/x.c"));
    assert_true(dependencies_equal(a, &original, "src/x.c", &twice, "/tmp/x.c"));
    assert_false(dependencies_equal(a, &original, "src/x.c", &other, "/tmp/x.c"));
    assert_false(dependencies_equal(a, &original, "src/x.c", &fewer, "/tmp/x.c"));
}

static void finds_words_that_stand_alone(void **state) {
    arena *a = *state;
    const char *folder = temporary_create(a);
    const char *path = arena_format(a, "%s/x.c", folder);
    word_list files = {0};
    words_add(a, &files, path);
    static const struct {
        const char *text;
        bool found;
    } cases[] = {{"#pragma omp for", true},
                 {"omp", true},
                 {"compute(romp, omp_x)", false},
                 {"", false},
                 {"x omp\n", true},
                 {"_omp omp2", false}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        write_text(path, cases[i].text);
        assert_int_equal(dependencies_mention(a, &files, "omp"), cases[i].found);
    }
    temporary_remove(folder);
    assert_true(dependencies_mention(a, &files, "omp")); /* an unreadable file may name it */
}

static void reports_become_one_line(void **state) {
    arena *a = *state;
    const char *folder = temporary_create(a);
    const char *report = arena_format(a, "%s/report", folder);
    const char *log = arena_format(a, "%s/log", folder);
    write_text(report, "{ \"a b\" : \"c \\\" d\\\\\" ,\n\t\"e\": [ 1, 2 ] }\n");
    assert_true(build_report_append(a, report, log));
    assert_true(build_report_append(a, report, log));
    char here[PATH_MAX];
    assert_non_null(getcwd(here, sizeof here));
    const char *line =
        arena_format(a, "{\"directory\":\"%s\",\"a b\":\"c \\\" d\\\\\",\"e\":[1,2]}\n", here);
    assert_string_equal(file_read(a, log, NULL), arena_format(a, "%s%s", line, line));
    assert_false(build_report_append(a, "/no/such/report", log));
    temporary_remove(folder);
}

static int set_up(void **state) {
    *state = arena_new();
    return 0;
}

static int tear_down(void **state) {
    arena_free(*state);
    return 0;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(table_is_sorted),           cmocka_unit_test(every_entry_finds_itself),
        cmocka_unit_test(longest_beginning_wins),    cmocka_unit_test(kinds_of_commands),
        cmocka_unit_test(output_is_joined_or_apart), cmocka_unit_test(splits_as_gcc_does),
        cmocka_unit_test(response_files_come_back),  cmocka_unit_test(reads_dependency_files),
        cmocka_unit_test(compares_dependencies),     cmocka_unit_test(finds_words_that_stand_alone),
        cmocka_unit_test(reports_become_one_line),
    };
    return cmocka_run_group_tests_name("driver options", tests, set_up, tear_down);
}
