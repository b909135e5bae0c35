/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "redcc/compilers.h"

#include <string.h>

#include "frontend/frontend.h"
#include "frontend/predefined.h"
#include "ir/ir_text.h"

/* The flags that give clang's parser gcc's predefined macros. */
#define AS_GCC                                                                                     \
    "-fgnuc-version=" REDCC_GCC_VERSION, FLAGS_WITHOUT_CLANG, FLAGS_WITHOUT_FEATURES,              \
        FLAGS_OF_GCC_TYPES

/* gcc's answers to these tests are unknown, so the tree must be the same if all answers are 0. */
#define WITHOUT_ANSWERS "-D__has_builtin(x)=0", "-D__has_attribute(x)=0", "-D__has_c_attribute(x)=0"

/* Removes attributes that do not affect the analysis. */
static void drop_attributes(char *text) {
    static const char flag[] = " !attributes";
    const size_t length = sizeof flag - 1;
    char *to = text;
    for (const char *from = text; *from;) {
        if (*from == ' ' && strncmp(from, flag, length) == 0)
            from += length;
        else
            *to++ = *from++;
    }
    *to = 0;
}

/** Returns the unit without marks of skipped branches, so that text_of does not show which branches
 * were compiled. It is harmless if other branches are compiled, provided that the declarations in
 * them, which are compared, are equal. */
static ir_unit without_branches(arena *a, const ir_unit *unit) {
    ir_unit shown = *unit;
    shown.directives = ARENA_ARRAY(a, ir_directive, unit->directive_count + 1);
    for (unsigned i = 0; i < unit->directive_count; i++) {
        shown.directives[i] = unit->directives[i];
        shown.directives[i].is_skipped &= unit->directives[i].kind == IR_DIRECTIVE_PRAGMA;
    }
    return shown;
}

static const char *text_of(arena *a, const ir_unit *unit) {
    const ir_unit shown = without_branches(a, unit);
    buffer text = {0};
    ir_print(&text, &shown);
    char *copy = buffer_take(a, &text);
    drop_attributes(copy);
    return copy;
}

static bool is_same(arena *a, const source *file, const string_list *flags, const char *expected,
                    const char *const *more) {
    string_list all = {0};
    for (unsigned i = 0; i < flags->count; i++)
        VECTOR_PUSH(a, &all, flags->items[i]);
    for (; *more; more++)
        VECTOR_PUSH(a, &all, *more);
    const frontend_result parsed = frontend_parse(a, file, all.count, all.items);
    return parsed.unit && parsed.unit->error_count == 0 &&
           strcmp(text_of(a, parsed.unit), expected) == 0;
}

bool compilers_agree(arena *a, const source *file, const string_list *flags, const ir_unit *unit) {
    static const char *const as_gcc[] = {AS_GCC, NULL};
    static const char *const without_answers[] = {AS_GCC, WITHOUT_ANSWERS, NULL};
    if (!unit->text.compiler_word)
        return true;
    const char *expected = text_of(a, unit);
    return is_same(a, file, flags, expected, as_gcc) &&
           is_same(a, file, flags, expected, without_answers);
}
