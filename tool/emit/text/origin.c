/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/text/origin.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MARK_BEGIN = 1, MARK_END = 2 };

/* A mark is MARK_BEGIN, a letter, two numbers, MARK_END. The first number is the address of the
 * object meant, or an offset in the file. The second is the number of bytes, before or after the
 * mark, to which it applies. */
static const char format[] = "\x01%c%llx,%lx\x02";
static const char letters[] = "ndtvc"; /* indexed by origin_kind */
_Static_assert(sizeof letters - 1 == ORIGIN_COPY + 1, "a letter for each kind");

static const char *mark(arena *a, origin_kind kind, const void *meant, size_t length) {
    return arena_format(a, format, letters[kind], (unsigned long long)(uintptr_t)meant,
                        (unsigned long)length);
}

static const char *marked(arena *a, origin_kind kind, const char *name, const ir_declared *meant) {
    return arena_format(a, "%s%s", name, mark(a, kind, meant, strlen(name)));
}

const char *origin_variable(arena *a, const ir_variable *variable) {
    return variable->stands_for ? variable->name /* a variable that redcc introduced */
                                : marked(a, ORIGIN_NAME, variable->name, variable->declared);
}

const char *origin_function(arena *a, const ir_function *function) {
    return marked(a, ORIGIN_NAME, function->name, function->declared);
}

const char *origin_declarator(arena *a, const ir_variable *variable) {
    return variable->stands_for ? variable->name
                                : marked(a, ORIGIN_DECLARED, variable->name, variable->declared);
}

const char *origin_function_declarator(arena *a, const ir_function *function) {
    return marked(a, ORIGIN_DECLARED, function->name, function->declared);
}

const char *origin_type(arena *a, const ir_type *type) {
    if (!type || !type->spelling)
        return NULL;
    return origin_spelling(a, type, type->spelling);
}

const char *origin_spelling(arena *a, const ir_type *type, const char *spelling) {
    return arena_format(a, "%s%s", mark(a, ORIGIN_TYPE, type, strlen(spelling)), spelling);
}

const char *origin_value(arena *a, const ir_type *type, const char *expression) {
    return arena_format(a, "%s%s", mark(a, ORIGIN_VALUE, type, 0), expression);
}

void origin_copy_bytes(buffer *out, const char *bytes, uint32_t from, uint32_t length) {
    buffer_format(out, format, letters[ORIGIN_COPY], (unsigned long long)from,
                  (unsigned long)length);
    buffer_append(out, bytes, length);
}

void origin_copy(buffer *out, const char *text, uint32_t begin, uint32_t end) {
    assert(begin <= end);
    origin_copy_bytes(out, text + begin, begin, end - begin);
}

/* ---- reading ------------------------------------------------------------------------------- */

typedef struct mark_text {
    origin_kind kind;
    unsigned long long meant;
    unsigned long length;
    const char *after;
} mark_text;

static bool read_mark(const char *at, const char *end, mark_text *read) {
    const char *letter = at + 1 < end && *at == MARK_BEGIN && at[1] ? strchr(letters, at[1]) : NULL;
    if (!letter)
        return false;
    char *comma, *close;
    read->kind = (origin_kind)(letter - letters);
    read->meant = strtoull(at + 2, &comma, 16);
    if (*comma != ',')
        return false;
    read->length = strtoul(comma + 1, &close, 16);
    read->after = close + 1;
    return *close == MARK_END && close < end;
}

const char *origin_skip(const char *at, const char *end) {
    assert(at <= end);
    mark_text read;
    if (!read_mark(at, end, &read))
        return at;
    return read.after + (read.kind == ORIGIN_COPY ? read.length : 0);
}

bool origin_is_copy(const char *at, const char *end) {
    uint32_t from;
    return origin_copied(at, end, &from);
}

const char *origin_copied(const char *at, const char *end, uint32_t *from) {
    mark_text read;
    if (!read_mark(at, end, &read) || read.kind != ORIGIN_COPY)
        return NULL;
    *from = (uint32_t)read.meant;
    return read.after;
}

typedef struct unmarking {
    arena *arena;
    buffer out;
    bool has_crlf;
    origin_list *origins;
} unmarking;

static void add(unmarking *u, origin item) {
    assert(item.begin <= item.end);
    if (u->origins)
        VECTOR_PUSH(u->arena, &u->origins->items, item);
}

static bool lacks_return(const unmarking *u, char byte) {
    const bool has_return = u->out.length > 0 && u->out.data[u->out.length - 1] == '\r';
    return u->has_crlf && byte == '\n' && !has_return;
}

static void put(unmarking *u, char byte) {
    if (lacks_return(u, byte))
        buffer_byte(&u->out, '\r');
    buffer_byte(&u->out, byte);
}

/* Appends copied bytes. If carriage returns are inserted into the copy, it is recorded as several
 * origins. */
static void put_copy(unmarking *u, const char *text, uint32_t from, size_t length) {
    origin piece = {.kind = ORIGIN_COPY, .begin = (uint32_t)u->out.length, .from = from};
    for (size_t i = 0; i < length; i++) {
        if (lacks_return(u, text[i])) {
            piece.end = (uint32_t)u->out.length;
            add(u, piece);
            piece.begin = piece.end + 1;
            piece.from = from + (uint32_t)i;
        }
        put(u, text[i]);
    }
    piece.end = (uint32_t)u->out.length;
    add(u, piece);
}

static void put_marked(unmarking *u, const mark_text *read) {
    const uint32_t here = (uint32_t)u->out.length;
    const uint32_t length = (uint32_t)read->length;
    const void *meant = (const void *)(uintptr_t)read->meant;
    if (read->kind == ORIGIN_COPY)
        put_copy(u, read->after, (uint32_t)read->meant, read->length);
    else if (read->kind == ORIGIN_TYPE || read->kind == ORIGIN_VALUE)
        add(u, (origin){.kind = read->kind, .begin = here, .end = here + length, .type = meant});
    else
        add(u, (origin){.kind = read->kind, .begin = here - length, .end = here, .meant = meant});
}

const char *origin_unmark(arena *a, const char *text, size_t length, bool has_crlf,
                          origin_list *origins) {
    unmarking u = {.arena = a, .has_crlf = has_crlf, .origins = origins};
    const char *at = text, *const end = text + length;
    while (at < end) {
        mark_text read;
        if (!read_mark(at, end, &read)) {
            put(&u, *at++);
            continue;
        }
        put_marked(&u, &read);
        at = read.after + (read.kind == ORIGIN_COPY ? read.length : 0);
    }
    const char *plain = arena_copy(a, u.out.length > 0 ? u.out.data : "", u.out.length);
    buffer_free(&u.out);
    return plain;
}
