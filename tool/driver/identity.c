/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/identity.h"

#include <ctype.h>
#include <string.h>

#include "driver/condition.h"
#include "driver/files.h"
#include "support/source.h"

/* Macros that depend on the compiler's version, or on options that are not passed to redcc. */
static const char *const sensitive[] = {
    "__CET__",
    "__EXCEPTIONS",
    "__FAST_MATH__",
    "__FINITE_MATH_ONLY__",
    "__FP_FAST_FMA",
    "__FP_FAST_FMAF",
    "__GNUC_PATCHLEVEL__",
    "__GNUC_PREREQ",
    "__GNUC_PREREQ__",
    "__NO_MATH_ERRNO__",
    "__PIC__",
    "__PIE__",
    "__SANITIZE_ADDRESS__",
    "__SANITIZE_THREAD__",
    "__SSP__",
    "__VERSION__",
    "__clang_minor__",
    "__clang_patchlevel__",
    "__clang_version__",
    "__glibc_clang_prereq",
    "__glibc_has_attribute",
    "__has_attribute",
    "__has_builtin",
    "__has_c_attribute",
    "__has_extension",
    "__has_feature",
    "__has_warning",
    "__pic__",
    "__pie__",
};

/* Further macros that `gcc -dM -E` and `clang -dM -E` define differently (gcc 12, clang 19,
 * x86-64). */
static const char *const sensitive_for_gcc[] = {
    "__BIGGEST_ALIGNMENT__",
    "__BITINT_MAXWIDTH__",
    "__BOOL_WIDTH__",
    "__CONSTANT_CFSTRINGS__",
    "__EVEX256__",
    "__EVEX512__",
    "__FLOAT128__",
    "__FLOAT_WORD_ORDER__",
    "__GCC_IEC_559",
    "__GCC_IEC_559_COMPLEX",
    "__GXX_ABI_VERSION",
    "__HAVE_SPECULATION_SAFE_VALUE",
    "__INVPCID__",
    "__LITTLE_ENDIAN__",
    "__LLONG_WIDTH__",
    "__LONG_LONG_WIDTH__",
    "__MMX_WITH_SSE__",
    "__NO_MATH_INLINES",
    "__POINTER_WIDTH__",
    "__SCHAR_WIDTH__",
    "__SIZEOF_FLOAT80__",
    "__STDC_IEC_559_COMPLEX__",
    "__STDC_IEC_559__",
    "__STDC_IEC_60559_BFP__",
    "__STDC_IEC_60559_COMPLEX__",
    "__STDC_ISO_10646__",
    "__WINT_UNSIGNED__",
    "__llvm__",
    "__seg_fs",
    "__seg_gs",
};

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

/* The gcc version that clang claims, and the versions of gcc 5 and later. */
enum { CLANG_MAJOR = 4, CLANG_MINOR = 2, FIRST_MAJOR = 5, LAST_MAJOR = 40, LAST_MINOR = 9 };
/* The versions of libclang that redcc can be built with, and later ones. */
enum { FIRST_CLANG = 17, LAST_CLANG = 60 };

static bool is_in(const char *word, const char *const *list, size_t count) {
    for (size_t i = 0; i < count; i++)
        if (strcmp(word, list[i]) == 0)
            return true;
    return false;
}

/* Is the word a macro of a family that gcc and clang define differently? */
static bool is_of_sensitive_family(const char *word) {
    static const char *const begins[] = {
        "__DEC",        "__OBJC_",         "__CLANG_",         "__ATOMIC_HLE_",
        "__core_",      "__tune_",         "__GNUC_EXECUTION", "__GNUC_WIDE_EXECUTION",
        "__STDC_EMBED", "__CHAR16_TYPE__", "__CHAR32_TYPE__"};
    for (size_t i = 0; i < COUNT(begins); i++)
        if (strncmp(word, begins[i], strlen(begins[i])) == 0)
            return true;
    const bool is_integer = strncmp(word, "__INT", 5) == 0 || strncmp(word, "__UINT", 6) == 0;
    return (is_integer && (source_ends_with(word, "_C") || strstr(word, "FAST"))) ||
           strstr(word, "_FMT") ||
           (strncmp(word, "__FLT", 5) == 0 && isdigit((unsigned char)word[5]));
}

static bool is_sensitive(const char *word, bool is_clang) {
    return is_in(word, sensitive, COUNT(sensitive)) ||
           (is_clang && strcmp(word, "__clang_major__") == 0) ||
           (!is_clang && (is_in(word, sensitive_for_gcc, COUNT(sensitive_for_gcc)) ||
                          is_of_sensitive_family(word)));
}

static bool is_only_of_clang(const char *word) {
    return strcmp(word, "__clang__") == 0 || strcmp(word, "__clang_major__") == 0;
}

static bool is_version(const char *word) {
    return strcmp(word, "__GNUC__") == 0 || strcmp(word, "__GNUC_MINOR__") == 0 ||
           is_only_of_clang(word);
}

/* The line around `at`, joined with the lines that end in a backslash, without the backslashes. */
static char *logical_line(arena *a, const char *text, const char *at) {
    const char *first = at;
    while (first > text && !(first[-1] == '\n' && !(first > text + 1 && first[-2] == '\\') &&
                             !(first > text + 2 && first[-2] == '\r' && first[-3] == '\\')))
        first--;
    buffer line = {0};
    for (const char *c = first; *c; c++) {
        const char *end = c + (*c == '\\') + (c[0] == '\\' && c[1] == '\r');
        if (*c == '\\' && *end == '\n') {
            c = end;
            continue;
        }
        if (*c == '\n')
            break;
        buffer_byte(&line, *c);
    }
    return buffer_take(a, &line);
}

static bool is_same_for_all_versions(const char *expression) {
    const int last_minor = strstr(expression, "__GNUC_MINOR__") ? LAST_MINOR : 0;
    const condition_value clang =
        condition_evaluate(expression, (condition_version){CLANG_MAJOR, CLANG_MINOR, FIRST_CLANG});
    for (int major = FIRST_CLANG; major <= LAST_CLANG; major++) {
        const condition_value other =
            condition_evaluate(expression, (condition_version){CLANG_MAJOR, CLANG_MINOR, major});
        if (!condition_equal(&clang, &other))
            return false;
    }
    for (int major = FIRST_MAJOR; major <= LAST_MAJOR; major++)
        for (int minor = 0; minor <= last_minor; minor++) {
            const condition_value gcc =
                condition_evaluate(expression, (condition_version){major, minor, 0});
            if (!condition_equal(&clang, &gcc))
                return false;
        }
    return true;
}

/* Is this occurrence of `word` harmless, because the line in which it occurs means the same to all
 * compilers? */
static bool is_harmless(const char *line, const char *word) {
    line += strspn(line, " \t");
    if (*line != '#')
        return false;
    line++;
    line += strspn(line, " \t");
    size_t length = strspn(line, "abcdefghijklmnopqrstuvwxyz");
    const char *rest = line + length;
    if ((length == 5 && strncmp(line, "ifdef", 5) == 0) ||
        (length == 6 && strncmp(line, "ifndef", 6) == 0))
        return !is_only_of_clang(word); /* both gcc and clang define __GNUC__, __GNUC_MINOR__ */
    bool is_condition = (length == 2 && strncmp(line, "if", 2) == 0) ||
                        (length == 4 && strncmp(line, "elif", 4) == 0);
    return is_condition && is_same_for_all_versions(rest);
}

const char *identity_asked(arena *a, const char *text, bool is_clang) {
    for (const char *at = strstr(text, "__"); at && *at; at = strstr(at, "__")) {
        size_t length = 0;
        while (source_is_word_byte(at[length]))
            length++;
        if (at > text && source_is_word_byte(at[-1])) {
            at += length;
            continue;
        }
        const char *word = arena_copy(a, at, length);
        /* compilers for C23 define __STDC_VERSION__ as 2020.. or 2023.. */
        const bool asks_c23 = strcmp(word, "__STDC_VERSION__") == 0 &&
                              strstr(logical_line(a, text, at), "202") != NULL;
        if (is_sensitive(word, is_clang) || (!is_clang && asks_c23) ||
            (!is_clang && is_version(word) && !is_harmless(logical_line(a, text, at), word)))
            return word;
        at += length;
    }
    return NULL;
}

static bool is_of_system(const char *path) {
    return strncmp(path, "/usr/include/", 13) == 0 || strncmp(path, "/usr/lib/", 9) == 0;
}

const char *identity_asked_in(arena *a, const word_list *files, bool is_clang) {
    for (unsigned i = 0; i < files->count; i++) {
        if (is_of_system(files->items[i]))
            continue;
        size_t length;
        const char *text = file_read(a, files->items[i], &length);
        if (!text || strlen(text) != length)
            return "of what cannot be read";
        const char *word = identity_asked(a, text, is_clang);
        if (word)
            return word;
    }
    return NULL;
}
