/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "frontend/directives.h"

#include <assert.h>
#include <ctype.h>
#include <string.h>

#include "support/vector.h"

typedef struct scanner {
    arena *arena;
    const char *begin, *at, *end;
    bool is_line_begin; /* the current line so far has only blanks and comments */
    VECTOR(ir_directive) found;
} scanner;

unsigned splice_length(const char *p, const char *end) {
    assert(p <= end);
    unsigned length = 0;
    if (p < end && *p == '\\')
        length = 1;
    else if (end - p >= 3 && strncmp(p, "?\?/", 3) == 0) /* the trigraph for a backslash */
        length = 3;
    else
        return 0;
    if (p + length < end && p[length] == '\n')
        return length + 1;
    if (end - p >= length + 2 && p[length] == '\r' && p[length + 1] == '\n')
        return length + 2;
    return 0;
}

static bool starts_with(const scanner *s, const char *text) {
    size_t length = strlen(text);
    if (*s->at != *text)
        return false;
    return (size_t)(s->end - s->at) >= length && strncmp(s->at, text, length) == 0;
}

static void skip_block_comment(scanner *s) {
    assert(starts_with(s, "/*"));
    s->at += 2;
    while (s->at < s->end && !starts_with(s, "*/")) {
        const char *star = memchr(s->at + 1, '*', (size_t)(s->end - s->at - 1));
        s->at = star != NULL ? star : s->end;
    }
    s->at = s->at < s->end ? s->at + 2 : s->end;
}

/* Skips to the end of the line, or past the closing quote. An unterminated quote ends with its
 * line: branches that are not compiled may contain one. */
static void skip_to(scanner *s, char close) {
    while (s->at < s->end && *s->at != '\n') {
        if (*s->at != '\\' && *s->at != '?' && *s->at != close) {
            s->at++;
            continue;
        }
        unsigned splice = splice_length(s->at, s->end);
        if (splice > 0) {
            s->at += splice;
        } else if (close != 0 && *s->at == '\\' && s->at + 1 < s->end && s->at[1] != '\n') {
            s->at += 2;
        } else if (close != 0 && *s->at == close) {
            s->at++;
            return;
        } else {
            s->at++;
        }
    }
}

static void skip_quoted(scanner *s) {
    assert(*s->at == '"' || *s->at == '\'');
    char close = *s->at++;
    skip_to(s, close);
}

/* May the byte begin a comment, a string, a splice or a directive? */
static bool may_begin_piece(char c) {
    return c == '/' || c == '\\' || c == '?' || c == '"' || c == '\'' || c == '#' || c == '%';
}

/* Skips a comment, string, character constant or splice as a whole; otherwise one byte. */
static void skip_piece(scanner *s) {
    if (!may_begin_piece(*s->at)) {
        s->at++;
        return;
    }
    unsigned splice = splice_length(s->at, s->end);
    if (splice > 0)
        s->at += splice;
    else if (starts_with(s, "/*"))
        skip_block_comment(s);
    else if (starts_with(s, "//"))
        skip_to(s, 0);
    else if (*s->at == '"' || *s->at == '\'')
        skip_quoted(s);
    else
        s->at++;
}

const char *piece_end(const char *at, const char *end) {
    scanner s = {.at = at, .end = end};
    assert(at <= end);
    skip_piece(&s);
    return s.at;
}

static void add(scanner *s, ir_directive_kind kind, const char *from) {
    assert(s->begin <= from && from <= s->at && s->at <= s->end);
    const char *to = s->at;
    while (to > from && isspace((unsigned char)to[-1]))
        to--;
    ir_directive directive = {
        .kind = kind,
        .range = {(uint32_t)(from - s->begin), (uint32_t)(to - s->begin)},
        .text = arena_copy(s->arena, from, (size_t)(to - from)),
    };
    VECTOR_PUSH(s->arena, &s->found, directive);
}

/* Reads the directive's name after the "#", skipping splices and comments. */
static void read_name(scanner *s, char name[16]) {
    size_t length = 0;
    while (s->at < s->end && *s->at != '\n') {
        if (length == 0 && (*s->at == ' ' || *s->at == '\t')) {
            s->at++;
        } else if (splice_length(s->at, s->end) > 0 || (length == 0 && starts_with(s, "/*"))) {
            skip_piece(s);
        } else if (isalnum((unsigned char)*s->at) || *s->at == '_') {
            if (length < 15)
                name[length++] = *s->at;
            s->at++;
        } else {
            break;
        }
    }
    name[length] = 0;
}

static ir_directive_kind kind_of(const char *name) {
    static const struct {
        const char *name;
        ir_directive_kind kind;
    } known[] = {
        {"if", IR_DIRECTIVE_IF},         {"ifdef", IR_DIRECTIVE_IF},
        {"ifndef", IR_DIRECTIVE_IF},     {"elif", IR_DIRECTIVE_ELSE},
        {"elifdef", IR_DIRECTIVE_ELSE},  {"elifndef", IR_DIRECTIVE_ELSE},
        {"else", IR_DIRECTIVE_ELSE},     {"endif", IR_DIRECTIVE_ENDIF},
        {"pragma", IR_DIRECTIVE_PRAGMA},
    };
    for (unsigned i = 0; i < sizeof known / sizeof known[0]; i++)
        if (strcmp(name, known[i].name) == 0)
            return known[i].kind;
    return IR_DIRECTIVE_OTHER;
}

/* Reads a directive. `hash` is the length of its "#". */
static void read_directive(scanner *s, unsigned hash) {
    assert(hash > 0 && s->at + hash <= s->end);
    const char *from = s->at;
    char name[16];
    s->at += hash;
    read_name(s, name);
    while (s->at < s->end && *s->at != '\n')
        skip_piece(s);
    add(s, kind_of(name), from);
}

static unsigned hash_length(const scanner *s) {
    if (*s->at == '#')
        return 1;
    if (starts_with(s, "%:"))
        return 2;
    return starts_with(s, "?\?=") ? 3 : 0;
}

/* Reads _Pragma ( "..." ) as a whole. */
static void read_pragma_operator(scanner *s) {
    const char *from = s->at;
    s->at += strlen("_Pragma");
    while (s->at < s->end && *s->at != ')' && *s->at != ';')
        skip_piece(s);
    if (s->at < s->end && *s->at == ')')
        s->at++;
    add(s, IR_DIRECTIVE_PRAGMA, from);
}

static void read_word(scanner *s) {
    const char *word = s->at;
    while (s->at < s->end && source_is_name_byte(*s->at))
        s->at++;
    if (s->at - word == 7 && strncmp(word, "_Pragma", 7) == 0) {
        s->at = word;
        read_pragma_operator(s);
    }
}

static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

static void scan(scanner *s) {
    if (starts_with(s, "\xef\xbb\xbf"))
        s->at += 3;
    s->is_line_begin = true;
    while (s->at < s->end) {
        if (*s->at == '\n') {
            s->is_line_begin = true;
            s->at++;
        } else if (is_blank(*s->at)) {
            s->at++;
        } else if (source_is_name_byte(*s->at)) {
            s->is_line_begin = false;
            read_word(s);
        } else if (starts_with(s, "/*") || splice_length(s->at, s->end) > 0) {
            skip_piece(s); /* what follows on the line may still begin a directive */
        } else if (s->is_line_begin && hash_length(s) > 0) {
            read_directive(s, hash_length(s));
        } else {
            s->is_line_begin = false;
            skip_piece(s);
        }
    }
}

ir_directive *directives_in(arena *a, const char *text, size_t length, unsigned *count) {
    scanner s = {.arena = a, .begin = text, .at = text, .end = text + length};
    scan(&s);
    *count = s.found.count;
    return s.found.items;
}

void find_directives(arena *a, ir_unit *unit) {
    unit->directives =
        directives_in(a, unit->source->text, unit->source->length, &unit->directive_count);
    for (unsigned i = 1; i < unit->directive_count; i++) /* binary searches need this order */
        assert(unit->directives[i - 1].range.end <= unit->directives[i].range.begin);
}
