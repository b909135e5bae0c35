/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ir_reader/sexp.h"

#include <string.h>

#include "support/vector.h"

typedef struct reader {
    arena *arena;
    const char *at, *end;
    const char *line_begin;
    unsigned line;
    buffer scratch;
    const char *message;
} reader;

typedef struct open_list {
    sexp *list;
    VECTOR(sexp *) items;
} open_list;

const char *sexp_expected(arena *a, const sexp *at, const char *what) {
    return arena_format(a, "%u:%u: expected %s", at->line, at->column, what);
}

/* ---- quoted text --------------------------------------------------------------------------- */

static bool is_octal(char c) {
    return c >= '0' && c <= '7';
}

/* Reads an escape; `from` points after the backslash. Returns the position after the escape, or
 * NULL. */
static const char *unescape(buffer *out, const char *from, const char *end) {
    if (from == end)
        return NULL;
    if (end - from >= 3 && is_octal(from[0]) && is_octal(from[1]) && is_octal(from[2])) {
        int code = (from[0] - '0') * 64 + (from[1] - '0') * 8 + (from[2] - '0');
        buffer_byte(out, (char)code);
        return code < 256 ? from + 3 : NULL;
    }
    switch (*from) {
    case 'n':
        buffer_byte(out, '\n');
        break;
    case 'r':
        buffer_byte(out, '\r');
        break;
    case 't':
        buffer_byte(out, '\t');
        break;
    case '\\':
    case '"':
        buffer_byte(out, *from);
        break;
    default:
        return NULL;
    }
    return from + 1;
}

const char *sexp_unquote(buffer *out, const char *from, const char *end) {
    for (from++; from != NULL && from < end;) {
        if (*from == '"')
            return from + 1;
        if (*from == '\\') {
            from = unescape(out, from + 1, end);
        } else {
            buffer_byte(out, *from);
            from++;
        }
    }
    return NULL;
}

/* ---- the reader ---------------------------------------------------------------------------- */

static void advance_to(reader *r, const char *to) {
    for (; r->at < to; r->at++)
        if (*r->at == '\n') {
            r->line++;
            r->line_begin = r->at + 1;
        }
}

static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

static void skip_blanks(reader *r) {
    const char *p = r->at;
    while (p < r->end && (is_blank(*p) || *p == ';')) {
        if (*p == ';')
            while (p < r->end && *p != '\n')
                p++;
        else
            p++;
    }
    advance_to(r, p);
}

static sexp *new_sexp(reader *r, sexp_kind kind) {
    sexp *s = ARENA_NEW(r->arena, sexp);
    s->kind = kind;
    s->line = r->line;
    s->column = (unsigned)(r->at - r->line_begin) + 1;
    return s;
}

static sexp *expect(reader *r, const char *what) {
    sexp here = *new_sexp(r, SEXP_ATOM);
    r->message = sexp_expected(r->arena, &here, what);
    return NULL;
}

static sexp *read_string(reader *r) {
    sexp *s = new_sexp(r, SEXP_STRING);
    r->scratch.length = 0;
    const char *after = sexp_unquote(&r->scratch, r->at, r->end);
    if (after == NULL)
        return expect(r, "a quoted text that ends, with known escapes");
    s->text = arena_copy(r->arena, r->scratch.data, r->scratch.length);
    advance_to(r, after);
    return s;
}

/* Returns the end of the atom at `p`, or NULL if a quote or a parenthesis in it does not end. */
static const char *atom_end(reader *r, const char *p) {
    unsigned depth = 0;
    while (p < r->end) {
        if (*p == '"') {
            r->scratch.length = 0;
            p = sexp_unquote(&r->scratch, p, r->end);
            if (p == NULL)
                return NULL;
            continue;
        }
        if (depth == 0 && (is_blank(*p) || *p == ')' || *p == ';'))
            return p;
        depth += *p == '(';
        depth -= *p == ')';
        p++;
    }
    return depth == 0 ? p : NULL;
}

static sexp *read_atom(reader *r) {
    const char *end = atom_end(r, r->at);
    if (end == NULL)
        return expect(r, "a type with its parentheses and quotes closed");
    sexp *s = new_sexp(r, SEXP_ATOM);
    s->text = arena_copy(r->arena, r->at, (size_t)(end - r->at));
    advance_to(r, end);
    return s;
}

/* Reads the next atom, string, or list whose items are still to be read. Returns NULL if it fails
 * and has set the message. */
static sexp *read_token(reader *r) {
    if (*r->at == '(') {
        sexp *list = new_sexp(r, SEXP_LIST);
        r->at++;
        return list;
    }
    return *r->at == '"' ? read_string(r) : read_atom(r);
}

static sexp *read_list(reader *r) {
    VECTOR(open_list) open = {0};
    for (;;) {
        skip_blanks(r);
        if (r->at == r->end)
            return expect(r, open.count > 0 ? "')'" : "'('");
        sexp *done;
        if (*r->at == ')' && open.count > 0) {
            r->at++;
            open_list *top = &open.items[--open.count];
            done = top->list;
            done->items = top->items.items;
            done->count = top->items.count;
        } else {
            if (*r->at != '(' && open.count == 0)
                return expect(r, "'('");
            done = read_token(r);
            if (done == NULL)
                return NULL;
            if (done->kind == SEXP_LIST) {
                if (open.count == SEXP_DEPTH)
                    return expect(r, "less deeply nested lists");
                VECTOR_PUSH(r->arena, &open, (open_list){.list = done});
                continue;
            }
        }
        if (open.count == 0)
            return done;
        VECTOR_PUSH(r->arena, &open.items[open.count - 1].items, done);
    }
}

sexp *sexp_read(arena *a, const char *text, size_t length, const char **message) {
    reader r = {.arena = a, .at = text, .end = text + length, .line_begin = text, .line = 1};
    sexp *s = read_list(&r);
    if (s != NULL) {
        skip_blanks(&r);
        if (r.at != r.end)
            s = expect(&r, "the end of the text");
    }
    buffer_free(&r.scratch);
    if (s == NULL)
        *message = r.message;
    return s;
}
