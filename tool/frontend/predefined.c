/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "frontend/predefined.h"

#include <string.h>

#include "support/source.h"

/* Removes the names that identify clang. Other macros that only clang defines stay defined, because
 * clang's own headers need them. A program that names one of these macros is not analysed
 * (compiler_words.c). */
static const char *const without_clang[] = {FLAGS_WITHOUT_CLANG};
static const char *const types_of_gcc[] = {FLAGS_OF_GCC_TYPES};
static const char *const without_features[] = {FLAGS_WITHOUT_FEATURES};

/* Operators of #if. Although gcc may not have them, they stay defined, because clang's headers use
 * them without testing whether they exist. */
static const char *const operators[] = {
    "__building_module",
    "__has_attribute",
    "__has_builtin",
    "__has_c_attribute",
    "__has_constexpr_builtin",
    "__has_cpp_attribute",
    "__has_declspec_attribute",
    "__has_embed",
    "__has_extension",
    "__has_feature",
    "__has_warning",
    "__is_identifier",
    "__is_target_arch",
    "__is_target_environment",
    "__is_target_os",
    "__is_target_variant_environment",
    "__is_target_variant_os",
    "__is_target_vendor",
};

bool is_feature_test(const char *text, size_t length) {
    for (size_t i = 0; i < sizeof operators / sizeof *operators; i++)
        if (strlen(operators[i]) == length && memcmp(operators[i], text, length) == 0)
            return true;
    return false;
}

static size_t name_length(const char *text) {
    size_t length = 0;
    while (source_is_name_byte(text[length]))
        length++;
    return length;
}

static void add(arena *a, parse_flags *flags, const char *flag) {
    const char *name = flag + 2;
    *map_at(flags->predefined, name, name_length(name)) = flags;
    VECTOR_PUSH(a, &flags->items, flag);
}

/* Adds the line `#define NAME BODY` or `#define NAME(PARAMETERS) BODY` as a flag. */
static void add_line(arena *a, parse_flags *flags, const char *line, size_t length) {
    static const char word[] = "#define ";
    if (length < sizeof word || strncmp(line, word, sizeof word - 1) != 0)
        return;
    const char *name = line + sizeof word - 1, *end = line + length;
    const char *after = name + name_length(name);
    if (after < end && *after == '(')
        while (after < end && *after++ != ')') {
        }
    const char *body = after < end ? after + 1 : end;
    add(a, flags,
        arena_format(a, "-D%.*s=%.*s", (int)(after - name), name, (int)(end - body), body));
}

void add_predefined(arena *a, parse_flags *flags, const char *path) {
    const char *message;
    const source *file = source_read(a, path, &message);
    flags->predefined = map_new(a);
    if (!file) {
        flags->unseen = path;
        return;
    }
    for (size_t i = 0; i < sizeof without_clang / sizeof *without_clang; i++)
        add(a, flags, without_clang[i]);
    bool is_clang = false;
    for (const char *line = file->text; *line;) {
        const char *end = strchr(line, '\n');
        const size_t length = end ? (size_t)(end - line) : strlen(line);
        is_clang |= strncmp(line, "#define __clang__ ", 18) == 0;
        add_line(a, flags, line, length);
        line += length + (end != NULL);
    }
    for (size_t i = 0; !is_clang && i < sizeof types_of_gcc / sizeof *types_of_gcc; i++)
        add(a, flags, types_of_gcc[i]);
    for (size_t i = 0; !is_clang && i < sizeof without_features / sizeof *without_features; i++)
        VECTOR_PUSH(a, &flags->items, without_features[i]);
}

void forget_predefined(parse_flags *flags, const char *definition) {
    if (strncmp(definition, "-D", 2) == 0 || strncmp(definition, "-U", 2) == 0)
        definition += 2;
    const size_t length = name_length(definition);
    if (flags->predefined && map_get(flags->predefined, definition, length))
        *map_at(flags->predefined, definition, length) = NULL;
}
