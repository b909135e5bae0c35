/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Parses the text of a #pragma redcc. */
#include "analysis/base/pragma.h"

#include <ctype.h>
#include <string.h>

#include "analysis/base/stateful.h"
#include "support/buffer.h"

static const char valid_pragmas[] =
    "valid are private(NAME, ...), independent, ignore, pure(NAME, ...)";

static const struct pragma_form {
    const char *word;
    pragma_word number;
    bool has_names;
} forms[] = {
    {"ignore", PRAGMA_IGNORE, false},
    {"independent", PRAGMA_INDEPENDENT, false},
    {"private", PRAGMA_PRIVATE, true},
    {"pure", PRAGMA_PURE, true},
};

/* ---- text without splices and comments ------------------------------------------------------ */

typedef struct reader {
    arena *memory;
    char *text;       /* the text, with splices removed and comments replaced by blanks */
    uint32_t *places; /* [length + 1]: for each byte of `text`, its offset in the directive */
    size_t at;
} reader;

static size_t splice_at(const char *p) {
    const size_t mark = *p == '\\' ? 1 : strncmp(p, "?\?/", 3) == 0 ? 3 : 0;
    if (mark && p[mark] == '\n')
        return mark + 1;
    return mark && p[mark] == '\r' && p[mark + 1] == '\n' ? mark + 2 : 0;
}

static void drop_splices(reader *r, const char *text) {
    const size_t length = strlen(text);
    r->text = arena_allocate(r->memory, length + 1);
    r->places = ARENA_ARRAY(r->memory, uint32_t, length + 1);
    size_t count = 0;
    for (size_t i = 0; i < length;) {
        const size_t splice = splice_at(text + i);
        if (splice) {
            i += splice;
            continue;
        }
        r->places[count] = (uint32_t)i;
        r->text[count++] = text[i++];
    }
    r->places[count] = (uint32_t)length;
}

static void blank_comments(reader *r) {
    for (char *p = r->text; *p; p++) {
        if (p[0] == '/' && p[1] == '/') {
            memset(p, ' ', strlen(p));
        } else if (p[0] == '/' && p[1] == '*') {
            const char *end = strstr(p + 2, "*/");
            memset(p, ' ', end ? (size_t)(end + 2 - p) : strlen(p));
        }
    }
}

/* ---- words ---------------------------------------------------------------------------------- */

static void skip_blanks(reader *r) {
    while (isspace((unsigned char)r->text[r->at]))
        r->at++;
}

static bool take(reader *r, const char *token) {
    skip_blanks(r);
    const size_t length = strlen(token);
    if (strncmp(r->text + r->at, token, length) != 0)
        return false;
    r->at += length;
    return true;
}

/* Takes the next word; "" if there is none. */
static const char *take_word(reader *r) {
    skip_blanks(r);
    const size_t begin = r->at;
    while (source_is_name_byte(r->text[r->at]))
        r->at++;
    return arena_copy(r->memory, r->text + begin, r->at - begin);
}

static bool take_keyword(reader *r, const char *keyword) {
    const size_t before = r->at;
    const bool is_it = strcmp(take_word(r), keyword) == 0;
    if (!is_it)
        r->at = before;
    return is_it;
}

/* Skips `#pragma redcc` or `_Pragma("redcc`. For the latter, blanks out the closing quote and what
 * follows. */
static bool take_head(reader *r) {
    if (take(r, "#") || take(r, "%:") || take(r, "?\?="))
        return take_keyword(r, "pragma") && take_keyword(r, "redcc");
    if (!take_keyword(r, "_Pragma") || !take(r, "("))
        return false;
    char *quote = strchr(r->text + r->at, '"');
    char *end = quote ? strchr(quote + 1, '"') : NULL;
    if (!end)
        return false;
    memset(end, ' ', strlen(end));
    r->at = (size_t)(quote + 1 - r->text);
    return take_keyword(r, "redcc");
}

/* ---- one pragma ----------------------------------------------------------------------------- */

static const char *error_at(reader *r, size_t at, uint32_t *offset, const char *message) {
    *offset = r->places[at];
    return message;
}

static const char *read_names(reader *r, const char *word, user_pragma *result, uint32_t *offset) {
    VECTOR(const char *) names = {0};
    if (!take(r, "("))
        return error_at(r, r->at, offset,
                        arena_format(r->memory, "'%s' takes names: %s(NAME, ...)", word, word));
    do {
        skip_blanks(r);
        const size_t begin = r->at;
        const char *name = take_word(r);
        if (!*name || isdigit((unsigned char)*name))
            return error_at(r, begin, offset, "a name is expected here");
        if (strcmp(word, "pure") == 0 && stateful_effect(name))
            return error_at(r, begin, offset,
                            arena_format(r->memory, "'%s' %s, so that it has side effects", name,
                                         stateful_effect(name)));
        VECTOR_PUSH(r->memory, &names, name);
    } while (take(r, ","));
    if (!take(r, ")"))
        return error_at(r, r->at, offset, "',' or ')' is expected here");
    result->name_count = names.count;
    result->names = names.items;
    return NULL;
}

static const char *text_of(arena *a, const char *word, const user_pragma *pragma) {
    buffer out = {0};
    buffer_text(&out, word);
    for (unsigned i = 0; i < pragma->name_count; i++)
        buffer_format(&out, "%s%s", i ? ", " : "(", pragma->names[i]);
    if (pragma->name_count)
        buffer_text(&out, ")");
    const char *text = arena_copy(a, out.data, out.length);
    buffer_free(&out);
    return text;
}

const char *pragma_parse(arena *a, const char *text, user_pragma *result, uint32_t *offset) {
    reader r = {.memory = a};
    *result = (user_pragma){.word = PRAGMA_OTHER};
    drop_splices(&r, text);
    blank_comments(&r);
    if (!take_head(&r))
        return NULL;
    skip_blanks(&r);
    const size_t begin = r.at;
    const char *word = take_word(&r);
    const struct pragma_form *form = NULL;
    for (size_t i = 0; i < sizeof forms / sizeof *forms; i++)
        if (strcmp(word, forms[i].word) == 0)
            form = &forms[i];
    if (!form && !*word)
        return error_at(&r, begin, offset,
                        arena_format(a, "a pragma of redcc is expected here; %s", valid_pragmas));
    if (!form)
        return error_at(&r, begin, offset,
                        arena_format(a, "redcc has no pragma '%s'; %s", word, valid_pragmas));
    const char *problem = form->has_names ? read_names(&r, word, result, offset) : NULL;
    if (problem)
        return problem;
    skip_blanks(&r);
    if (r.text[r.at])
        return error_at(
            &r, r.at, offset,
            arena_format(a, "nothing is expected after '%s'", text_of(a, word, result)));
    result->word = form->number;
    result->text = text_of(a, word, result);
    return NULL;
}
