/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/openmp_directive.h"

#include <assert.h>
#include <ctype.h>
#include <string.h>

/* ---- words --------------------------------------------------------------------------------- */

const char *openmp_token(const char *text, size_t *length) {
    while (isspace((unsigned char)*text))
        text++;
    *length = 0;
    while (source_is_name_byte(text[*length]))
        ++*length;
    if (*length == 0 && *text)
        *length = 1;
    return text;
}

bool openmp_is_name(const char *text, const char *at) {
    if (!source_is_name_byte(*at) || isdigit((unsigned char)*at))
        return false;
    while (at > text && isspace((unsigned char)at[-1]))
        at--;
    return at == text || (at[-1] != '.' && !(at - text > 1 && at[-1] == '>' && at[-2] == '-'));
}

static bool is_word(const char *at, size_t length, const char *word) {
    return strlen(word) == length && memcmp(at, word, length) == 0;
}

/* The text after this word; NULL if it begins with another one. */
static const char *after(const char *text, const char *word) {
    size_t length;
    const char *at = openmp_token(text, &length);
    return is_word(at, length, word) ? at + length : NULL;
}

bool directive_is_openmp_pragma(const ir_directive *d) {
    if (d->kind != IR_DIRECTIVE_PRAGMA || !d->text || *d->text != '#')
        return false;
    const char *at = after(d->text + 1, "pragma");
    return at && after(at, "omp");
}

const char *openmp_plain_text(arena *a, const char *text) {
    char *plain = arena_copy(a, text, strlen(text));
    char *to = plain;
    for (const char *from = plain; *from;) {
        if (from[0] == '\\' && (from[1] == '\n' || (from[1] == '\r' && from[2] == '\n'))) {
            from += from[1] == '\r' ? 3 : 2;
        } else if (from[0] == '/' && from[1] == '*') {
            const char *end = strstr(from + 2, "*/");
            from = end ? end + 2 : from + strlen(from);
            *to++ = ' ';
        } else if (from[0] == '/' && from[1] == '/') {
            break;
        } else {
            *to++ = *from++;
        }
    }
    *to = 0;
    return plain;
}

/* Behind the bracket that closes the one at `text`; NULL: none does. */
static const char *after_brackets(const char *text) {
    unsigned depth = 0;
    for (; *text; text++) {
        depth += *text == '(' || *text == '[';
        if ((*text == ')' || *text == ']') && --depth == 0)
            return text + 1;
    }
    return NULL;
}

/* ---- clauses ------------------------------------------------------------------------------- */

typedef struct reader {
    arena *memory;
    VECTOR(openmp_item) items;
    const char *kept;
} reader;

static void add(reader *r, openmp_item item) {
    VECTOR_PUSH(r->memory, &r->items, item);
}

/* a, b[:n], c[0:n][:3] */
static void read_list(reader *r, openmp_clause_kind kind, reduction_operator op, const char *at) {
    for (;;) {
        size_t length;
        const char *name = openmp_token(at, &length);
        if (length == 0 || isdigit((unsigned char)*name) || !source_is_name_byte(*name)) {
            r->kept = "a list of names that is not understood";
            return;
        }
        openmp_item item = {kind, op, arena_copy(r->memory, name, length), NULL};
        at = openmp_token(name + length, &length);
        while (at && *at == '[') {
            const char *inside = at + 1;
            at = after_brackets(at);
            if (at)
                item.section =
                    arena_format(r->memory, "%s%s%.*s", item.section ? item.section : "",
                                 item.section ? "][" : "", (int)(at - inside) - 1, inside);
            at = at ? openmp_token(at, &length) : NULL;
        }
        add(r, item);
        if (at && length == 0)
            return;
        if (!at || *at != ',') {
            r->kept = "a list of names that is not understood";
            return;
        }
        at++;
    }
}

/* op: list */
static void read_reduction(reader *r, const char *inside) {
    static const struct {
        const char *text;
        reduction_operator op;
    } known[] = {{"+", REDUCTION_SUM},       {"-", REDUCTION_SUM},       {"*", REDUCTION_PRODUCT},
                 {"min", REDUCTION_MINIMUM}, {"max", REDUCTION_MAXIMUM}, {"&", REDUCTION_AND},
                 {"|", REDUCTION_OR},        {"^", REDUCTION_XOR}};
    size_t length;
    const char *op = openmp_token(inside, &length);
    const char *list = after(op + length, ":");
    for (size_t i = 0; list && i < sizeof known / sizeof *known; i++)
        if (is_word(op, length, known[i].text)) {
            read_list(r, OPENMP_REDUCTION, known[i].op, list);
            return;
        }
    r->kept = "a reduction by another operator, or with a modifier";
}

static bool assigns(const char *text) {
    for (const char *at = strchr(text, '='); at; at = strchr(at + 1, '=')) {
        const bool compares =
            at > text && strchr("!<>", at[-1]) && !(at - text > 1 && at[-2] == at[-1]);
        if (at[1] == '=')
            at++;
        else if (!compares)
            return true;
    }
    return strstr(text, "++") || strstr(text, "--");
}

/* An expression of names, numbers and operators. */
static void read_expression(reader *r, openmp_clause_kind kind, const char *inside) {
    const char *rest = kind == OPENMP_IF ? after(inside, "parallel") : NULL;
    rest = rest ? after(rest, ":") : NULL;
    inside = rest ? rest : inside;
    if (strpbrk(inside, "\"'{};#\\") || assigns(inside) ||
        (strchr(inside, ':') && !strchr(inside, '?')))
        r->kept = "a clause with an expression that is not understood";
    add(r, (openmp_item){kind, REDUCTION_NONE, inside, NULL});
}

static bool is_of(const char *at, size_t length, const char *const *words) {
    for (; *words; words++)
        if (is_word(at, length, *words))
            return true;
    return false;
}

static const char *clause_text(reader *r, const char *word, size_t length, const char *inside) {
    return arena_format(r->memory, inside ? "the clause '%.*s(%s)'" : "the clause '%.*s'",
                        (int)length, word, inside);
}

/* Of parallel for. */
static void read_loop_clause(reader *r, const char *word, size_t length, const char *inside) {
    static const char *const neutral[] = {"shared", "default", "schedule", NULL};
    if (!inside)
        r->kept = clause_text(r, word, length, NULL);
    else if (is_word(word, length, "private"))
        read_list(r, OPENMP_PRIVATE, REDUCTION_NONE, inside);
    else if (is_word(word, length, "firstprivate"))
        read_list(r, OPENMP_FIRSTPRIVATE, REDUCTION_NONE, inside);
    else if (is_word(word, length, "lastprivate"))
        read_list(r, OPENMP_LASTPRIVATE, REDUCTION_NONE, inside);
    else if (is_word(word, length, "reduction"))
        read_reduction(r, inside);
    else if (is_word(word, length, "if"))
        read_expression(r, OPENMP_IF, inside);
    else if (is_word(word, length, "num_threads"))
        read_expression(r, OPENMP_NUM_THREADS, inside);
    else if (!is_of(word, length, neutral) &&
             !(is_word(word, length, "collapse") && strcmp(inside, "1") == 0))
        r->kept = clause_text(r, word, length, inside);
}

/* The clauses of atomic and critical: only hints, and words for the default. */
static void read_lock_clause(reader *r, const char *word, size_t length, const char *inside) {
    static const char *const neutral[] = {"update", "relaxed", "hint", NULL};
    if (!is_of(word, length, neutral))
        r->kept = clause_text(r, word, length, inside);
}

static void read_clauses(reader *r, openmp_construct construct, const char *at) {
    while (!r->kept) {
        size_t length;
        const char *word = openmp_token(at, &length);
        if (length == 0)
            return;
        const char *inside = NULL;
        size_t unused;
        at = openmp_token(word + length, &unused);
        if (*at == '(' && *word != ',') {
            const char *end = after_brackets(at);
            if (!end) {
                r->kept = "a clause that is not understood";
                return;
            }
            inside = arena_copy(r->memory, at + 1, (size_t)(end - at) - 2);
            at = end;
        }
        if (*word == ',')
            continue;
        if (construct == OPENMP_PARALLEL_FOR)
            read_loop_clause(r, word, length, inside);
        else
            read_lock_clause(r, word, length, inside);
    }
}

/* ---- the directive ------------------------------------------------------------------------- */

/* A name of the directive's that a macro may replace; NULL: none. */
static const char *macro_in(arena *a, const ir_unit *unit, const char *text) {
    size_t length;
    const char *end = text + strlen(text);
    const char *name =
        unit->text.macros ? source_find_name(text, end, unit->text.macros, &length) : NULL;
    return name ? arena_copy(a, name, length) : NULL;
}

/* The construct; *rest: its clauses. */
static openmp_construct construct_of(const char *text, const char **rest) {
    const char *at = after(text, "parallel");
    at = at ? after(at, "for") : NULL;
    if (at) {
        *rest = at;
        return OPENMP_PARALLEL_FOR;
    }
    if ((*rest = after(text, "atomic")))
        return OPENMP_ATOMIC;
    if ((*rest = after(text, "critical"))) {
        const char *name = after(*rest, "(");
        const char *end = name ? strchr(name, ')') : NULL;
        *rest = end ? end + 1 : *rest;
        return OPENMP_CRITICAL;
    }
    return OPENMP_OTHER;
}

openmp_directive openmp_read(arena *a, const ir_unit *unit, const ir_directive *d) {
    assert(d->text);
    reader r = {.memory = a};
    openmp_directive result = {.construct = OPENMP_OTHER};
    const char *text = openmp_plain_text(a, d->text);
    if (strstr(text, "?\?/")) /* a trigraph that may join lines */
        return (openmp_directive){OPENMP_OTHER, 0, NULL, "a trigraph"};
    const char *rest = after(after(text + 1, "pragma"), "omp");
    const char *macro = macro_in(a, unit, rest);
    result.construct = construct_of(rest, &rest);
    if (result.construct == OPENMP_OTHER)
        result.kept = "the construct, which is none of 'parallel for', 'atomic' and 'critical'";
    else if (macro)
        result.kept = arena_format(a, "the macro '%s'", macro);
    if (result.kept)
        return result;
    read_clauses(&r, result.construct, rest);
    result.kept = r.kept;
    result.items = r.items.items;
    result.item_count = r.items.count;
    return result;
}
