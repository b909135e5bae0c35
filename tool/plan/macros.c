/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Macros of the program that would change generated text. A macro may have the name of a member of
 * the runtime's structures (`worker.first`), of a keyword, or of a variable of the user that the
 * generated text names. In text copied from the user's file, macros have their intended meaning.
 */
#include "plan/macros.h"

#include <assert.h>
#include <ctype.h>
#include <string.h>

static bool is_name_start(char c) {
    return isalpha((unsigned char)c) || c == '_' || c == '$' || (unsigned char)c >= 0x80;
}

static const char *skip_quoted(const char *at, const char *end) {
    assert(at < end && (*at == '"' || *at == '\''));
    const char quote = *at++;
    while (at < end && *at != quote)
        at += *at == '\\' && at + 1 < end ? 2 : 1;
    return at < end ? at + 1 : end;
}

static const char *skip_directive(const char *at, const char *end) {
    const char *line_end = memchr(at, '\n', (size_t)(end - at));
    return line_end ? line_end : end;
}

static const char *skip_comment(const char *at, const char *end) {
    assert(end - at >= 2 && at[0] == '/' && at[1] == '*');
    for (at += 2; at + 1 < end; at++)
        if (at[0] == '*' && at[1] == '/')
            return at + 2;
    return end;
}

/** Is the word a predefined macro that generated text uses intentionally (emit/body,
 * redcc/loop.h)? */
static bool is_meant(const char *word, size_t length) {
    static const char *const meant[] = {"__ATOMIC_RELAXED", "__ATOMIC_ACQUIRE"};
    for (size_t i = 0; i < sizeof meant / sizeof *meant; i++)
        if (length == strlen(meant[i]) && memcmp(word, meant[i], length) == 0)
            return true;
    return false;
}

/** Does the preprocessor replace this word, which ends at `after`? */
static bool is_replaced(const map *macros, const char *word, const char *after, const char *end) {
    assert(word < after && after <= end);
    if (is_meant(word, (size_t)(after - word)))
        return false;
    const void *kind = map_get(macros, word, (size_t)(after - word));
    while (after < end && isspace((unsigned char)*after))
        after++;
    return kind == IR_MACRO_AS_OBJECT ||
           (kind == IR_MACRO_AS_FUNCTION && (after == end || *after == '('));
}

const char *macro_name_in(arena *a, const ir_unit *unit, const char *text, size_t length) {
    const char *at = text, *const end = text + length;
    while (unit->text.macros && at < end) {
        const char *const word = at;
        if (*at == '"' || *at == '\'') {
            at = skip_quoted(at, end);
        } else if (*at == '#' && (at == text || at[-1] == '\n')) {
            at = skip_directive(at, end);
        } else if (*at == '/' && at + 1 < end && at[1] == '*') {
            at = skip_comment(at, end);
        } else if (source_is_name_byte(*at)) { /* numbers too: no macro has such a name */
            while (at < end && source_is_name_byte(*at))
                at++;
            if (is_name_start(*word) && is_replaced(unit->text.macros, word, at, end))
                return arena_copy(a, word, (size_t)(at - word));
        } else {
            at++;
        }
    }
    return NULL;
}

/** All words of the runtime's headers, listed by this folder's CMakeLists.txt. */
static const char *const words_of_header[] = {
#include "header_words.inc"
};

const char *macro_name_in_head(const ir_unit *unit) {
    for (size_t i = 0;
         unit->text.macros_before && i < sizeof words_of_header / sizeof *words_of_header; i++)
        if (map_get(unit->text.macros_before, words_of_header[i], strlen(words_of_header[i])))
            return words_of_header[i];
    return NULL;
}

/** Does a variable or function of the program have this name? */
static bool is_own(const ir_unit *unit, const char *name) {
    for (unsigned i = 0; i < unit->variable_count; i++)
        if (unit->variables[i]->name && strcmp(unit->variables[i]->name, name) == 0)
            return true;
    for (unsigned i = 0; i < unit->function_count; i++)
        if (strcmp(unit->functions[i]->name, name) == 0)
            return true;
    return false;
}

static const void *meaning_of(const map *names, const char *name) {
    return names ? map_get(names, name, strlen(name)) : NULL;
}

/** Does the program, or one of its headers, declare this name of the runtime? */
static bool is_declared(const ir_unit *unit, const char *name) {
    return meaning_of(unit->text.names, name) || meaning_of(unit->text.inner_names, name) ||
           meaning_of(unit->text.macros, name) || is_own(unit, name);
}

/** The macros that the runtime's headers define, listed by CMakeLists.txt. */
static const char *const macros_of_header[] = {
#include "header_macros.inc"
};

/** Is the name one of the macros, or the beginning of one? A macro of the program may paste the
 *  rest to such a beginning. */
static bool may_be_macro(const char *name) {
    for (size_t i = 0; i < sizeof macros_of_header / sizeof *macros_of_header; i++)
        if (source_starts_with(macros_of_header[i], name))
            return true;
    return false;
}

const char *taken_name(const ir_unit *unit) {
    for (size_t i = 0; i < sizeof words_of_header / sizeof *words_of_header; i++) {
        const char *word = words_of_header[i];
        if ((source_starts_with(word, "redcc_") || source_starts_with(word, "REDCC_")) &&
            is_declared(unit, word))
            return word;
    }
    for (unsigned i = 0; i < unit->text.runtime_name_count; i++)
        if (may_be_macro(unit->text.runtime_names[i]))
            return unit->text.runtime_names[i];
    return NULL;
}

/** The words in the macros of loop.h and of the other headers for generated text, without the
 * runtime's own names. CMakeLists.txt lists them. The byte that follows a word is listed with it,
 * because a function-like macro replaces a word only before `(`. */
static const char *const words_of_macros[] = {
#include "macro_words.inc"
};

const char *macro_of_header_words(arena *a, const ir_unit *unit) {
    const char *name = NULL;
    for (size_t i = 0; !name && i < sizeof words_of_macros / sizeof *words_of_macros; i++)
        name = macro_name_in(a, unit, words_of_macros[i], strlen(words_of_macros[i]));
    return name;
}
