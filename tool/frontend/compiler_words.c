/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Does the program test which compiler compiles it? The parser is clang; the compiler may be
 * another. System headers are excluded: they are responsible for working with each. */
#define _GNU_SOURCE /* memmem */
#include <ctype.h>
#include <string.h>

#include "frontend/convert.h"
#include "frontend/flags.h"
#include "frontend/lexing.h"
#include "frontend/predefined.h"

/* An attribute, and a pragma, of gcc's: reverses the bytes of numbers in memory. clang ignores
 * it. */
static const char storage_order[] = "scalar_storage_order";

/* gcc's -fopenmp defines it, clang's does not. */
static const char threads[] = "_REENTRANT";

static const char *word_in(file_text file) {
    static const char *const words[] = {"__clang",     "__llvm__", "__GNUC",
                                        "__VERSION__", "__has_",   "__GCC"};
    const char *at = file.text, *end = file.text + file.length;
    while (at != NULL && at < end && (at = memmem(at, (size_t)(end - at), "__", 2)) != NULL) {
        for (unsigned i = 0; i < sizeof words / sizeof *words; i++) {
            const size_t length = strlen(words[i]);
            if ((size_t)(end - at) >= length && memcmp(at, words[i], length) == 0)
                return words[i];
        }
        at++;
    }
    return text_has(file, threads) ? threads : NULL;
}

/* If clang uses the compiler's macros: a name to which it still gives a meaning of its own. */
static const char *parsers_word_in(converter *c, file_text file) {
    const char *at = file.text, *end = file.text + file.length;
    while (at != NULL && at < end) {
        const char *word = at;
        while (at < end && source_is_name_byte(*at))
            at++;
        const size_t length = (size_t)(at - word);
        if (length > 2 && (is_compiler_question(word, length) ||
                           map_get(c->compiler.parsers_own, word, length) != NULL))
            return arena_copy(c->arena, word, length);
        at += length == 0;
    }
    return NULL;
}

/* After an attribute's name: do arguments begin, or may a macro or a comment precede them? */
static bool may_have_arguments(const char *at, const char *end) {
    return at < end && (*at == '(' || *at == '\\' || *at == '/');
}

/* The attribute optimize, by which gcc compiles a function with other options than the file; clang
 * ignores it on any declaration. The pragma is parsed separately. */
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

/* The attribute target, or target_clones: no declaration in the tree shows it if a macro spells its
 * name. */
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

/* In a condition, true and false are keywords of C23, and names without a value for older
 * compilers. */
static bool asks_truth(converter *c, CXFile file) {
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

/* Each copy of a text that makes it has another number. System headers may define a macro with it
 * for programs to use. */
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
        c->unit->text.compiler_word = word_in(text);
    c->unit->text.names_optimize |= names_optimize(text);
    c->unit->text.names_target |= names_target(text);
    if (asks_truth(c, file))
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

/* The body of a macro in the options is text of the program's, too. */
static void look_at_options(converter *c) {
    const parse_flags *flags = c->compiler.flags;
    for (unsigned i = 0; i < flags->items.count; i++) {
        const char *flag = flags->items.items[i];
        const file_text text = {flag, strlen(flag)};
        c->unit->text.names_optimize |= names_optimize(text);
        c->unit->text.names_target |= names_target(text);
    }
}

void find_compiler_words(converter *c) {
    look_at_options(c);
    clang_getInclusions(c->clang, visit, c);
}
