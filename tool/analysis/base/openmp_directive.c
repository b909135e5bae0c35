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

/* The text after the word, if it is the first token of `text`; otherwise NULL. */
static const char *after(const char *text, const char *word) {
    size_t length;
    const char *at = openmp_token(text, &length);
    return is_word(at, length, word) ? at + length : NULL;
}

/* The text after `omp` in `#pragma omp ...` or `_Pragma("omp ...")`; NULL if it is neither. */
static const char *after_omp(const char *text) {
    const char *at = *text == '#' ? after(text + 1, "pragma") : NULL;
    if (*text == '_' && (at = after(text, "_Pragma")) && (at = after(at, "(")))
        at = after(at, "\"");
    return at ? after(at, "omp") : NULL;
}

bool directive_is_openmp_pragma(const ir_directive *d) {
    return d->kind == IR_DIRECTIVE_PRAGMA && d->text && after_omp(d->text) &&
           (*d->text == '#' || !strchr(d->text, '\\'));
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

/* The text after the bracket that closes the bracket at `text`; NULL if none does. */
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

/* Reads a list such as a, b[:n], c[0:n][:3]. */
static void read_list(reader *r, openmp_item item, const char *at) {
    for (;;) {
        size_t length;
        const char *name = openmp_token(at, &length);
        if (length == 0 || isdigit((unsigned char)*name) || !source_is_name_byte(*name)) {
            r->kept = "a list of names that is not understood";
            return;
        }
        item.text = arena_copy(r->memory, name, length);
        item.section = NULL;
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

/* Reads the inside of reduction(op: list). */
static void read_reduction(reader *r, const char *inside) {
    static const struct {
        const char *text;
        reduction_operator op;
    } known[] = {{"+", REDUCTION_SUM},       {"-", REDUCTION_SUM},       {"*", REDUCTION_PRODUCT},
                 {"min", REDUCTION_MINIMUM}, {"max", REDUCTION_MAXIMUM}, {"&&", REDUCTION_NONE},
                 {"||", REDUCTION_NONE},     {"&", REDUCTION_AND},       {"|", REDUCTION_OR},
                 {"^", REDUCTION_XOR}};
    size_t length;
    const char *op = openmp_token(inside, &length);
    length += (*op == '&' || *op == '|') && op[1] == *op;
    const char *list = after(op + length, ":");
    for (size_t i = 0; list && i < sizeof known / sizeof *known; i++)
        if (is_word(op, length, known[i].text)) {
            read_list(r, (openmp_item){OPENMP_REDUCTION, known[i].op, .word = known[i].text}, list);
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

/* Reads a clause whose argument is an expression of names, numbers and operators. */
static void read_expression(reader *r, openmp_clause_kind kind, const char *word,
                            const char *inside) {
    const char *rest = kind == OPENMP_IF ? after(inside, "parallel") : NULL;
    rest = rest ? after(rest, ":") : NULL;
    inside = rest ? rest : inside;
    if (strpbrk(inside, "\"'{};#\\") || assigns(inside) ||
        (strchr(inside, ':') && !strchr(inside, '?')))
        r->kept = "a clause with an expression that is not understood";
    add(r, (openmp_item){kind, REDUCTION_NONE, inside, NULL, word});
}

/* The clauses of `parallel`, `for` and `parallel for` whose kind depends only on their name.
 * kind_of_loop_clause adds nowait and collapse. */
static const struct {
    const char *word;
    openmp_clause_kind kind;
} loop_clauses[] = {{"private", OPENMP_PRIVATE},
                    {"firstprivate", OPENMP_FIRSTPRIVATE},
                    {"lastprivate", OPENMP_LASTPRIVATE},
                    {"reduction", OPENMP_REDUCTION},
                    {"if", OPENMP_IF},
                    {"num_threads", OPENMP_NUM_THREADS},
                    {"schedule", OPENMP_SCHEDULE},
                    {"shared", OPENMP_SHARING},
                    {"default", OPENMP_SHARING},
                    {"proc_bind", OPENMP_OF_REGION},
                    {"copyin", OPENMP_OF_REGION},
                    {"allocate", OPENMP_OF_REGION}};

/* Is the text a single digit other than 0? */
static bool is_small_number(const char *text) {
    size_t length, rest;
    const char *number = openmp_token(text, &length);
    openmp_token(number + length, &rest);
    return length == 1 && rest == 0 && *number >= '1' && *number <= '9';
}

static openmp_clause_kind kind_of_loop_clause(openmp_construct construct, const char *word,
                                              const char *inside) {
    if (construct == OPENMP_FOR && !inside && strcmp(word, "nowait") == 0)
        return OPENMP_NOWAIT;
    for (size_t i = 0; inside && i < sizeof loop_clauses / sizeof *loop_clauses; i++)
        if (strcmp(loop_clauses[i].word, word) == 0)
            return loop_clauses[i].kind;
    return inside && strcmp(word, "collapse") == 0 && is_small_number(inside) ? OPENMP_COLLAPSE
                                                                              : OPENMP_OTHER_CLAUSE;
}

/* The kind of a clause of `atomic` or `critical`. Hints, and words that state the default, have no
 * effect. They get the kind OPENMP_SHARING, which needs no check. */
static openmp_clause_kind kind_of_lock_clause(const char *word, const char *inside) {
    (void)inside;
    return strcmp(word, "update") == 0 || strcmp(word, "relaxed") == 0 || strcmp(word, "hint") == 0
               ? OPENMP_SHARING
               : OPENMP_OTHER_CLAUSE;
}

static void read_clause(reader *r, openmp_clause_kind kind, const char *word, const char *inside) {
    switch (kind) {
    case OPENMP_PRIVATE:
    case OPENMP_FIRSTPRIVATE:
    case OPENMP_LASTPRIVATE:
        read_list(r, (openmp_item){kind, REDUCTION_NONE, .word = word}, inside);
        break;
    case OPENMP_REDUCTION:
        read_reduction(r, inside);
        break;
    case OPENMP_IF:
    case OPENMP_NUM_THREADS:
        read_expression(r, kind, word, inside);
        break;
    case OPENMP_OTHER_CLAUSE:
        add(r, (openmp_item){kind, REDUCTION_NONE,
                             arena_format(r->memory, inside ? "%s(%s)" : "%s", word, inside), NULL,
                             word});
        break;
    default:
        add(r, (openmp_item){kind, REDUCTION_NONE, inside, NULL, word});
    }
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
        word = arena_copy(r->memory, word, length);
        read_clause(r,
                    construct == OPENMP_ATOMIC || construct == OPENMP_CRITICAL
                        ? kind_of_lock_clause(word, inside)
                        : kind_of_loop_clause(construct, word, inside),
                    word, inside);
    }
}

/* ---- macros ---------------------------------------------------------------------------------- */

/* The text after `#define NAME` or `#undef NAME`, according to `word`; NULL if it is another
 * directive. */
static const char *after_definition(const char *text, const char *word, const char *name) {
    const char *at = *text == '#' ? after(text + 1, word) : NULL;
    return at ? after(at, name) : NULL;
}

/* The number to which the macro expands at `place`. NULL if it is unknown: the macro's last
 * definition in the file must be a number, and no file may have been included since. */
static const char *number_of_macro(arena *a, const ir_unit *unit, const char *name,
                                   uint32_t place) {
    const char *value = NULL;
    for (unsigned i = 0; i < unit->directive_count && unit->directives[i].range.begin < place;
         i++) {
        const ir_directive *d = &unit->directives[i];
        if (d->is_skipped || !d->text)
            continue;
        const char *text = openmp_plain_text(a, d->text);
        const char *rest = after_definition(text, "define", name);
        if (rest && isspace((unsigned char)*rest))
            value = rest;
        else if (rest || after_definition(text, "undef", name) || strstr(text, "include") ||
                 strstr(text, "import") || strstr(text, "pop_macro"))
            value = NULL;
    }
    if (!value)
        return NULL;
    size_t length, rest;
    const char *const bracket = after(value, "(");
    const char *const number = openmp_token(bracket ? bracket : value, &length);
    if (length == 0 || strspn(number, "0123456789") < length)
        return NULL;
    const char *const end = bracket ? after(number + length, ")") : number + length;
    if (!end)
        return NULL;
    openmp_token(end, &rest);
    return rest == 0 ? arena_copy(a, number, length) : NULL;
}

/* The text with macros replaced by their numbers. Stores in *macro the first macro that is no
 * number; NULL if there is none. */
static const char *with_numbers(arena *a, const ir_unit *unit, const char *text, uint32_t place,
                                const char **macro) {
    *macro = NULL;
    for (;;) {
        size_t length;
        const char *name = unit->text.macros ? source_find_name(text, text + strlen(text),
                                                                unit->text.macros, &length)
                                             : NULL;
        if (!name)
            return text;
        const char *const known = arena_copy(a, name, length);
        const char *const number = number_of_macro(a, unit, known, place);
        if (!number) {
            *macro = known;
            return text;
        }
        text = arena_format(a, "%.*s%s%s", (int)(name - text), text, number, name + length);
    }
}

/* ---- the directive ------------------------------------------------------------------------- */

/* The construct that the text names. Stores the text of its clauses in *rest. */
static openmp_construct construct_of(const char *text, const char **rest) {
    const char *at = after(text, "parallel");
    if (at && (*rest = after(at, "for")))
        return OPENMP_PARALLEL_FOR;
    if (at && !after(at, "sections") && !after(at, "master") && !after(at, "masked") &&
        !after(at, "loop") && !after(at, "workshare")) {
        *rest = at;
        return OPENMP_PARALLEL;
    }
    if ((*rest = after(text, "for")))
        return OPENMP_FOR;
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
    if (strstr(text, "?\?/")) /* the trigraph for a backslash, which may join lines */
        return (openmp_directive){OPENMP_OTHER, 0, NULL, "a trigraph"};
    const char *macro, *rest = with_numbers(a, unit, after_omp(text), d->range.begin, &macro);
    if (*text == '_')
        rest = arena_copy(a, rest, strcspn(rest, "\""));
    result.construct = construct_of(rest, &rest);
    if (result.construct == OPENMP_OTHER)
        result.kept =
            "the construct, which is none of 'parallel for', 'for', 'atomic' and 'critical'";
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

openmp_schedule openmp_schedule_of(const openmp_directive *d) {
    for (unsigned i = 0; i < d->item_count; i++)
        if (d->items[i].kind == OPENMP_SCHEDULE)
            return strstr(d->items[i].text, "dynamic") || strstr(d->items[i].text, "guided")
                       ? OPENMP_BY_TURNS
                       : OPENMP_STATIC;
    return OPENMP_NO_SCHEDULE;
}
