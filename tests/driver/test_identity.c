/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Conditions in a source that test compiler properties: finds those whose results differ between
 * libclang and the compiler. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "driver/condition.h"
#include "driver/identity.h"

static void assert_asks(const char *text, bool is_clang, const char *expected) {
    arena *a = arena_new();
    const char *found = identity_asked(a, text, is_clang);
    if (expected) {
        if (!found)
            fail_msg("not found in: %s", text);
        assert_string_equal(found, expected);
    } else if (found)
        fail_msg("'%s' found in: %s", found, text);
    arena_free(a);
}

static void texts_that_make_no_difference(void **state) {
    (void)state;
    static const char *const texts[] = {
        "",
        "int f(int n) { return n; }\n",
        "#ifdef __GNUC__\n#define LIKELY(x) __builtin_expect(x, 1)\n#endif\n",
        "#ifndef __GNUC__\n#define __attribute__(x)\n#endif\n",
        "#if defined(__GNUC__) && __GNUC__ >= 4\n",
        "#if __GNUC__ > 2 || (__GNUC__ == 2 && __GNUC_MINOR__ >= 96)\n",
        "#if defined(__GNUC__) && ((__GNUC__*100 + __GNUC_MINOR__) >= 302) && defined(__ELF__)\n",
        "#if defined __clang__ || defined __GNUC__\n",
        "#if (defined __clang__ && __clang_major__ >= 3) || (defined __GNUC__ && __GNUC__ >= 3)\n",
        "#if defined(__clang_major__) || defined(__GNUC__)\n",
        "#if __clang_major__ < 3 && __GNUC__ < 3\n",
        "  #  elif defined(__GNUC__) // a comment\n",
        "#if !defined(__GNUC__) || (OTHER > 3 && __GNUC__ < 3)\n",
        "#if defined(X) && \\\n    __GNUC__ >= 3\n",
        "#if defined(X) && \\\r\n    __GNUC__ >= 3\r\n",
        "#if HAS(x) && __GNUC__ >= 3 /* a comment */ && Y(1, 2)\n",
        "#if defined(__GNUC__) ? X : Y\n",
        "int __GNUC__x, a__clang__;\n",
        "#if __STDC_VERSION__ >= 199901L\n",
        "#if __FLT_EVAL_METHOD__ == 0 && __INT_MAX__ > 4\n",
    };
    for (unsigned i = 0; i < sizeof texts / sizeof texts[0]; i++)
        assert_asks(texts[i], false, NULL);
}

static void texts_that_make_one(void **state) {
    (void)state;
    static const struct {
        const char *text, *word;
    } cases[] = {
        {"#ifdef __clang__\n", "__clang__"},
        {"#ifdef __clang_major__\n", "__clang_major__"},
        {"#if __clang_major__ >= 3\n", "__clang_major__"},
        {"#if __clang_major__ >= 19 || __GNUC__ >= 3 && !defined __clang__\n", "__clang_major__"},
        {"#if !__clang_major__ || __clang_major__ > 20\n", "__clang_major__"},
        {"#if __clang_major__ > 20\n", "__clang_major__"},
        {"int a[__clang_major__];\n", "__clang_major__"},
        {"#ifdef __INT64_C\n", "__INT64_C"},
        {"n += sizeof(__UINT_FAST16_TYPE__);\n", "__UINT_FAST16_TYPE__"},
        {"#ifdef __FLT64_MAX__\n", "__FLT64_MAX__"},
        {"#ifdef __INTPTR_FMTd__\n", "__INTPTR_FMTd__"},
        {"#if __STDC_VERSION__ >= 202311L\n", "__STDC_VERSION__"},
        {"#if defined(__GNUC__) && !defined(__clang__)\n", "__GNUC__"},
        {"#if X\n#elif __GNUC__ >= 5\n", "__GNUC__"},
        {"#if __GNUC__ == 12\n", "__GNUC__"},
        {"#if __GNUC__ > 4 && defined(X)\n", "__GNUC__"},
        {"#if X && __GNUC_MINOR__ > 2\n", "__GNUC_MINOR__"},
        {"#if defined(X) && \\\n    __GNUC__ >= 7\n", "__GNUC__"},
        {"#if ((__GNUC__*100 + __GNUC_MINOR__) >= 403)\n", "__GNUC__"},
        {"#define VERSION (__GNUC__ * 100)\n", "__GNUC__"},
        {"#if AT_LEAST(__GNUC__, 7)\n", "__GNUC__"},
        {"#if __GNUC__ >= MINIMUM\n", "__GNUC__"},
        {"#if __GNUC__ >= 3 @\n", "__GNUC__"},
        {"#if 1 ? __GNUC__ : X\n", "__GNUC__"},
        {"#if __has_builtin(__builtin_clz)\n", "__has_builtin"},
        {"#ifdef __FAST_MATH__\n", "__FAST_MATH__"},
        {"#if defined(__llvm__)\n", "__llvm__"},
        {"#ifdef __LITTLE_ENDIAN__\n", "__LITTLE_ENDIAN__"},
        {"int a[__GNUC__];\n", "__GNUC__"},
        {"puts(__VERSION__);", "__VERSION__"},
        {"__GNUC__", "__GNUC__"},
    };
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++)
        assert_asks(cases[i].text, false, cases[i].word);
}

static void for_clang_only_versions_count(void **state) {
    (void)state;
    assert_asks("#if defined(__clang__) && __GNUC__ >= 7\n", true, NULL);
    assert_asks("#if __clang_major__ > 14\n", true, "__clang_major__");
    assert_asks("#if __has_attribute(x)\n", true, "__has_attribute");
    assert_asks("#ifdef __llvm__\n", true, NULL);
}

static void assert_value(const char *expression, int64_t value) {
    const condition_value found = condition_evaluate(expression, (condition_version){9, 3, 0});
    if (found.is_wrong || !found.is_known || found.value != value)
        fail_msg("%s: wrong %d, known %d, value %lld", expression, found.is_wrong, found.is_known,
                 (long long)found.value);
}

static void conditions_are_computed(void **state) {
    (void)state;
    assert_value("1 + 2 * 3 - 4 / 2 % 3", 5);
    assert_value("(1 + 2) * 3", 9);
    assert_value("10 - 4 - 3", 3);
    assert_value("1 << 4 | 3 & 2 ^ 1", 19);
    assert_value("!0 + -1 + ~0", -1);
    assert_value("2 > 1 == 1 && 3 <= 3", 1);
    assert_value("0x10 + 010 + 3UL", 27);
    assert_value("0 && X", 0);
    assert_value("X || 1", 1);
    assert_value("__GNUC__ * 100 + __GNUC_MINOR__", 903);
    assert_value("__GNUC__ > 8 ? 7 : X", 7);
    assert_value("defined __clang__ || defined(__GNUC__)", 1);
}

static void what_is_no_condition(void **state) {
    (void)state;
    static const char *const texts[] = {"",        "1 +",     "(1",      "1 2",      "1.5",
                                        "3 / 0",   "\"a\"",   "1 ? 2",   "X(Y(1))",  "defined",
                                        "1 << 99", "-1 >> 1", "'a' > 3", "defined()"};
    for (unsigned i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        const condition_value found = condition_evaluate(texts[i], (condition_version){9, 3, 0});
        if (!found.is_wrong)
            fail_msg("understood: %s", texts[i]);
    }
    char deep[5000];
    for (unsigned i = 0; i + 1 < sizeof deep; i++)
        deep[i] = i % 2 ? '!' : '(';
    deep[sizeof deep - 1] = 0;
    assert_true(condition_evaluate(deep, (condition_version){9, 3, 0}).is_wrong);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(texts_that_make_no_difference), cmocka_unit_test(texts_that_make_one),
        cmocka_unit_test(for_clang_only_versions_count), cmocka_unit_test(conditions_are_computed),
        cmocka_unit_test(what_is_no_condition),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
