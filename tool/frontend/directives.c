/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Finds the preprocessor's lines in the main file, where a loop's text may not be cut through. */
#include <ctype.h>
#include <string.h>

#include "frontend/translation.h"

typedef struct scanner {
    const char *text;
    uint32_t length;
    uint32_t at;
} scanner;

static bool starts(const scanner *s, uint32_t at, const char *word) {
    const size_t n = strlen(word);
    return s->length - at >= n && memcmp(s->text + at, word, n) == 0;
}

/* A backslash before the end of a line joins it to the next. */
static uint32_t splice_length(const scanner *s, uint32_t at) {
    if (starts(s, at, "\\\n"))
        return 2;
    return starts(s, at, "\\\r\n") ? 3 : 0;
}

static void skip_block_comment(scanner *s) {
    for (s->at += 2; s->at < s->length && !starts(s, s->at, "*/"); s->at++)
        ;
    s->at = s->at + 2 < s->length ? s->at + 2 : s->length;
}

static void skip_to_line_end(scanner *s) {
    while (s->at < s->length && s->text[s->at] != '\n') {
        const uint32_t splice = splice_length(s, s->at);
        if (splice)
            s->at += splice;
        else if (starts(s, s->at, "/*"))
            skip_block_comment(s);
        else
            s->at++;
    }
}

static void skip_quoted(scanner *s) {
    const char quote = s->text[s->at++];
    while (s->at < s->length && s->text[s->at] != quote && s->text[s->at] != '\n')
        s->at += s->text[s->at] == '\\' ? 2 : 1;
    if (s->at < s->length && s->text[s->at] == quote)
        s->at++;
}

static ir_directive_kind kind_of(const char *text, size_t length) {
    static const char *const conditionals[] = {"if", "else", "elif", "endif", "ifdef", "ifndef"};
    size_t at = 0, end;
    while (at < length && !isalpha((unsigned char)text[at]))
        at++;
    for (end = at; end < length && isalpha((unsigned char)text[end]); end++)
        ;
    for (size_t i = 0; i < sizeof conditionals / sizeof *conditionals; i++)
        if (strlen(conditionals[i]) == end - at &&
            memcmp(conditionals[i], text + at, end - at) == 0)
            return IR_DIRECTIVE_CONDITIONAL;
    return end - at == 6 && memcmp(text + at, "pragma", 6) == 0 ? IR_DIRECTIVE_PRAGMA
                                                                : IR_DIRECTIVE_OTHER;
}

void scan_directives(arena *a, ir_unit *unit) {
    scanner s = {.text = unit->source->text, .length = unit->source->length};
    VECTOR(ir_directive) list = {0};
    bool line_is_blank = true;
    while (s.at < s.length) {
        const char c = s.text[s.at];
        const uint32_t begin = s.at;
        const bool digraph = starts(&s, s.at, "%:");
        if (starts(&s, s.at, "/*")) {
            skip_block_comment(&s);
        } else if (starts(&s, s.at, "//") || ((c == '#' || digraph) && line_is_blank)) {
            skip_to_line_end(&s);
            if (c != '/') {
                const ir_directive directive = {.kind = kind_of(s.text + begin, s.at - begin),
                                                .range = {begin, s.at},
                                                .text =
                                                    arena_copy(a, s.text + begin, s.at - begin)};
                VECTOR_PUSH(a, &list, directive);
            }
        } else if (c == '"' || c == '\'') {
            skip_quoted(&s);
            line_is_blank = false;
        } else if (starts(&s, s.at, "_Pragma") &&
                   (begin == 0 ||
                    !(isalnum((unsigned char)s.text[begin - 1]) || s.text[begin - 1] == '_'))) {
            const ir_directive directive = {
                .kind = IR_DIRECTIVE_PRAGMA, .range = {begin, begin + 7}, .text = "_Pragma"};
            VECTOR_PUSH(a, &list, directive);
            s.at += 7;
            line_is_blank = false;
        } else {
            if (c == '\n')
                line_is_blank = true;
            else if (!isspace((unsigned char)c) && !splice_length(&s, s.at) &&
                     (unsigned char)c < 0x80)
                line_is_blank = false;
            s.at++;
        }
    }
    unit->directive_count = list.count;
    unit->directives = list.items;
}
