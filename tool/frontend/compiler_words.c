/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Finds names that may test which compiler is used. libclang parses as clang, but another compiler
 * may build the program. System headers are not searched for them: they are written for all
 * compilers. */
#define _GNU_SOURCE /* for memmem */
#include <assert.h>
#include <ctype.h>
#include <string.h>

#include "frontend/convert.h"
#include "frontend/flags.h"
#include "frontend/lexing.h"
#include "frontend/predefined.h"

/* An attribute and a pragma of gcc that set the byte order of numbers in memory. clang ignores
 * both. */
static const char storage_order[] = "scalar_storage_order";

/* A macro that gcc -fopenmp defines and clang -fopenmp does not. */
static const char threads[] = "_REENTRANT";

/* The whole name around `at`, copied. */
static const char *name_at(converter *c, file_text file, const char *at) {
    assert(file.text <= at && at <= file.text + file.length);
    const char *begin = at, *end = at;
    while (begin > file.text && source_is_name_byte(begin[-1]))
        begin--;
    while (end < file.text + file.length && source_is_name_byte(*end))
        end++;
    return arena_copy(c->arena, begin, (size_t)(end - begin));
}

static const char *word_in(converter *c, file_text file) {
    static const char *const words[] = {"__clang",     "__llvm__", "__GNUC",
                                        "__VERSION__", "__has_",   "__GCC"};
    const char *at = file.text, *end = file.text + file.length;
    while (at != NULL && at < end && (at = memmem(at, (size_t)(end - at), "__", 2)) != NULL) {
        for (unsigned i = 0; i < sizeof words / sizeof *words; i++) {
            const size_t length = strlen(words[i]);
            if ((size_t)(end - at) >= length && memcmp(at, words[i], length) == 0)
                return name_at(c, file, at);
        }
        at++;
    }
    return text_has(file, threads) ? threads : NULL;
}

/* Returns the first name in the file that is an operator of #if (__has_include and the like), or a
 * clang macro that the user's compiler does not define. NULL if there is none. */
static const char *parsers_word_in(converter *c, file_text file) {
    const char *at = file.text, *end = file.text + file.length;
    while (at != NULL && at < end) {
        const char *word = at;
        while (at < end && source_is_name_byte(*at))
            at++;
        const size_t length = (size_t)(at - word);
        if (length > 2 && (is_feature_test(word, length) ||
                           map_get(c->compiler.parsers_own, word, length) != NULL))
            return arena_copy(c->arena, word, length);
        at += length == 0;
    }
    return NULL;
}

/* May an attribute's arguments begin at `at`, directly or after a line splice or a comment? */
static bool may_have_arguments(const char *at, const char *end) {
    return at < end && (*at == '(' || *at == '\\' || *at == '/');
}

/* May the file use the attribute optimize? With it gcc compiles a function with other options than
 * the file's, and clang's tree does not show this. `#pragma GCC optimize` does not count here,
 * because it is parsed separately. */
static bool names_optimize(file_text file) {
    static const char word[] = "optimize", pragma[] = "GCC";
    const char *at = file.text, *const end = file.text + file.length;
    while (at != NULL && at < end && (at = memmem(at, (size_t)(end - at), word, sizeof word - 1))) {
        const char *before = at;
        at += sizeof word - 1;
        while (before > file.text && isspace((unsigned char)before[-1]))
            before--;
        if (before - file.text >= 3 && memcmp(before - 3, pragma, 3) == 0)
            continue;
        while (at < end && (*at == '_' || isspace((unsigned char)*at)))
            at++;
        if (may_have_arguments(at, end))
            return true;
    }
    return false;
}

/* May the file use the attribute target or target_clones? The tree does not show an attribute whose
 * name a macro spells. */
static bool names_target(file_text file) {
    static const char word[] = "target";
    const char *at = file.text, *const end = file.text + file.length;
    while (at != NULL && at < end && (at = memmem(at, (size_t)(end - at), word, sizeof word - 1))) {
        at += sizeof word - 1;
        const char *behind = at;
        while (behind < end && (source_is_name_byte(*behind) || isspace((unsigned char)*behind)))
            behind++;
        if (may_have_arguments(behind, end))
            return true;
    }
    return false;
}

/* Does a condition (#if) contain `true` or `false`? In C23 these words have values, but older
 * compilers treat them as undefined macros. Returns false for other standards than C23. */
static bool tests_true_or_false(converter *c, CXFile file) {
    if (!c->compiler.flags->is_c23)
        return false;
    const file_directives found = directives_of_file(c, file);
    for (unsigned i = 0; i < found.count; i++) {
        const char *text = found.items[i].text;
        if (strstr(text, "if") && (strstr(text, "true") || strstr(text, "false")))
            return true;
    }
    return false;
}

/* A predefined macro that expands to a new number at each use, so a copy of the text would expand
 * to other numbers. System headers are searched too, because their macros may use __COUNTER__. */
static const char counter[] = "__COUNTER__";

static void visit(CXFile file, CXSourceLocation *stack, unsigned depth, CXClientData data) {
    (void)stack;
    (void)depth;
    converter *c = data;
    const file_text text = text_of_file(c, file);
    if (text_has(text, counter))
        c->unit->text.names_counter = true;
    if (is_of_system(c, file))
        return;
    if (c->unit->text.compiler_word == NULL)
        c->unit->text.compiler_word = word_in(c, text);
    c->unit->text.names_optimize |= names_optimize(text);
    c->unit->text.names_target |= names_target(text);
    if (tests_true_or_false(c, file))
        c->unit->text.unseen_word = "true";
    const char *own = c->compiler.flags->predefined != NULL ? parsers_word_in(c, text) : NULL;
    if (own != NULL)
        c->unit->text.unseen_word = own;
    const char *doubt = text.length > 0 ? lexing_in_doubt(text.text, text.length) : NULL;
    if (doubt != NULL)
        c->unit->text.unseen_word = doubt;
    if (text_has(text, storage_order))
        c->unit->text.unseen_word = storage_order;
}

/* Searches the options, because the body of a macro that an option defines also belongs to the
 * program's text. */
static void search_options(converter *c) {
    const parse_flags *flags = c->compiler.flags;
    for (unsigned i = 0; i < flags->items.count; i++) {
        const char *flag = flags->items.items[i];
        const file_text text = {flag, strlen(flag)};
        c->unit->text.names_optimize |= names_optimize(text);
        c->unit->text.names_target |= names_target(text);
    }
}

void find_compiler_words(converter *c) {
    search_options(c);
    clang_getInclusions(c->clang, visit, c);
}
