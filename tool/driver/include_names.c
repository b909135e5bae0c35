/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/include_names.h"

#include <ctype.h>
#include <string.h>

#include "support/source.h"

static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/* If the backslash at `at` removes a line end (a splice), the text after that; else NULL. */
static const char *after_splice(const char *at) {
    do
        at++;
    while (is_blank(*at));
    at += at[0] == '\r' && at[1] == '\n';
    return *at == '\n' || *at == '\r' ? at + 1 : NULL;
}

/* The text with spliced lines joined: a word or a directive may extend over two. */
static const char *without_splices(arena *a, const char *text, size_t length) {
    const char *first = strchr(text, '\\');
    while (first && !after_splice(first))
        first = strchr(first + 1, '\\');
    if (!first)
        return text;
    char *joined = arena_copy(a, text, length), *to = joined + (first - text);
    for (const char *from = first; *from;) {
        const char *next = *from == '\\' ? after_splice(from) : NULL;
        if (next)
            from = next;
        else
            *to++ = *from++;
    }
    *to = 0;
    return joined;
}

static const char *skip_blanks(const char *at) {
    for (;;) {
        while (is_blank(*at))
            at++;
        const char *end = at[0] == '/' && at[1] == '*' ? strstr(at + 2, "*/") : NULL;
        if (!end)
            return at;
        at = end + 2;
    }
}

/* Is `at` at the beginning of a line, except for comments and a byte order mark? */
static bool begins_line(const char *text, const char *at) {
    while (at > text && is_blank(at[-1]))
        at--;
    return at == text || at[-1] == '\n' || at[-1] == '\r' ||
           (at >= text + 2 && at[-1] == '/' && at[-2] == '*') ||
           (at == text + 3 && strncmp(text, "\xEF\xBB\xBF", 3) == 0);
}

/* Is the word at `at` the name of a directive? */
static bool is_directive(const char *text, const char *at) {
    while (at > text && is_blank(at[-1]))
        at--;
    if (at == text)
        return false;
    if (at >= text + 2 && at[-1] == '/' && at[-2] == '*') /* # may be followed by a comment */
        return true;
    if (at[-1] == '#')
        return begins_line(text, at - 1);
    return at >= text + 2 && at[-1] == ':' && at[-2] == '%' && begins_line(text, at - 2);
}

/* Adds the macro at `at`, which may expand to the name of a header. Returns false if a compiler may
 * predefine the macro (reserved names, `linux`), or its name has bytes other than letters, digits
 * and _. Adds nothing if there is no name at `at`: the text is then in a comment, or is an
 * error. */
static bool add_macro(arena *a, const char *at, include_names *names) {
    size_t length = 0;
    bool has_capital = false;
    for (; source_is_word_byte(at[length]); length++)
        has_capital |= at[length] >= 'A' && at[length] <= 'Z';
    if (at[length] == '$' || at[length] == '\\' || (unsigned char)at[length] >= 0x80)
        return false;
    if (length == 0 || isdigit((unsigned char)*at))
        return true;
    words_add(a, &names->macros, arena_copy(a, at, length));
    return has_capital && *at != '_';
}

/* Adds the <name>, "name" or macro at `at`. Returns false if the name cannot be determined. */
static bool add_name(arena *a, const char *at, include_names *names) {
    if (*at != '<' && *at != '"')
        return add_macro(a, at, names);
    const char ends[] = {*at == '<' ? '>' : '"', '\n', '\r', 0};
    const size_t length = strcspn(at + 1, ends);
    if (at[1 + length] != ends[0])
        return false;
    words_add(a, *at == '<' ? &names->angled : &names->quoted, arena_copy(a, at + 1, length));
    return true;
}

static bool is(const char *word, size_t length, const char *name) {
    return strlen(name) == length && strncmp(word, name, length) == 0;
}

/* Adds the header requested by the word, `length` bytes at `at`. Returns false if the header cannot
 * be determined. */
static bool add_of_word(arena *a, const char *text, const char *at, size_t length,
                        include_names *names) {
    const char *next = skip_blanks(at + length);
    if (is(at, length, "__has_include") || is(at, length, "__has_include_next"))
        return *next != '(' || add_name(a, skip_blanks(next + 1), names);
    if (is(at, length, "include") || is(at, length, "include_next") || is(at, length, "import"))
        return !is_directive(text, at) || add_name(a, next, names);
    return true;
}

const char *include_names_find(arena *a, const char *text, size_t length, include_names *names) {
    static const char *const times[] = {"__TIME__", "__DATE__", "__TIMESTAMP__"};
    static const char *const stems[] = {"include", "import"};
    if (strlen(text) != length)
        return "it holds a zero byte";
    if (strstr(text, "?\?=") || strstr(text, "?\?/"))
        return "it has trigraphs";
    text = without_splices(a, text, length);
    names->text = text;
    for (size_t i = 0; i < sizeof times / sizeof *times; i++)
        if (source_has_word(text, strlen(text), times[i]))
            return "it names the time";
    if (source_has_word(text, strlen(text), "embed") ||
        source_has_word(text, strlen(text), "__has_embed"))
        return "it may embed a file";
    for (size_t i = 0; i < sizeof stems / sizeof *stems; i++)
        for (const char *at = text; (at = strstr(at, stems[i]));) {
            const char *word = at;
            while (word > text && source_is_word_byte(word[-1]))
                word--;
            while (source_is_word_byte(*at))
                at++;
            if (!add_of_word(a, text, word, (size_t)(at - word), names))
                return "a macro may make the name of a header";
        }
    return NULL;
}

/* Does the word before `at` test, undefine or include the macro at `at`, and so not define it? */
static bool is_only_tested(const char *text, const char *at) {
    static const char *const askers[] = {"defined", "ifdef",        "ifndef", "undef",
                                         "include", "include_next", "import"};
    while (at > text && (is_blank(at[-1]) || at[-1] == '('))
        at--;
    const char *end = at;
    while (at > text && source_is_word_byte(at[-1]))
        at--;
    for (size_t i = 0; i < sizeof askers / sizeof *askers; i++)
        if (is(at, (size_t)(end - at), askers[i]))
            return true;
    return false;
}

bool include_names_may_define(const char *text, const char *macro) {
    const size_t length = strlen(macro);
    for (const char *at = text; (at = strstr(at, macro)); at += length)
        if ((at == text || !source_is_word_byte(at[-1])) && !source_is_word_byte(at[length]) &&
            !is_only_tested(text, at))
            return true;
    return false;
}
