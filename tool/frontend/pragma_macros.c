/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Finds the program's macros that may expand to a pragma. Text that uses one contains a directive
 * that neither the text nor clang's tree shows. System headers are not searched: they define such
 * macros only for their own warnings. */
#include <string.h>

#include "frontend/convert.h"
#include "frontend/directives.h"
#include "frontend/lexing.h"

static const char pragma_operator[] = "_Pragma";

typedef struct definition {
    const char *name;
    size_t length;
    const char *rest; /* text after the name: parameters and replacement */
} definition;

typedef struct search {
    converter *converter;
    bool is_found;        /* a file contains the operator _Pragma */
    bool has_fenv_access; /* a file contains FENV_ACCESS */
    const char *hidden;   /* text that may hide a pragma from this search (see search_file). NULL
                           * if there is none */
    VECTOR(definition) all;
} search;

/* Returns the first universal character name (\\u or \\U) outside of comments; NULL if there is
 * none. If the file has a digit separator (a quote between digits) or the bytes below, comments
 * cannot be recognised reliably, so they are searched too. */
static const char *universal_name_in(file_text file) {
    static const char *const marks[] = {"\\u", "\\U"};
    const char *at = file.text, *const end = file.text + file.length;
    if (!text_has(file, marks[0]) && !text_has(file, marks[1]))
        return NULL;
    /* C89 has no // comments, so the bytes "slash, star, slash" may end a comment in C89, although
     * a scanner of newer C takes them for the beginning of a comment */
    const bool sees_comments =
        !lexing_has_digit_separator(file.text, file.length) && !text_has(file, "/*/");
    while (at < end) {
        const char *next = sees_comments ? piece_end(at, end) : end;
        const bool is_comment = sees_comments && next - at > 1 && strncmp(at, "/*", 2) == 0;
        const file_text piece = {at, (size_t)(next - at)};
        for (unsigned i = 0; !is_comment && i < sizeof marks / sizeof *marks; i++)
            if (text_has(piece, marks[i]) ||
                (piece.length == 1 && next < end && *at == '\\' && *next == marks[i][1]))
                return marks[i];
        at = next;
    }
    return NULL;
}

static void search_file(CXFile file, CXSourceLocation *stack, unsigned depth, CXClientData data) {
    (void)stack;
    (void)depth;
    search *s = data;
    if (is_of_system(s->converter, file))
        return;
    const file_text text = text_of_file(s->converter, file);
    s->is_found |= text_has(text, pragma_operator);
    s->has_fenv_access |= text_has(text, "FENV_ACCESS");
    /* The tree does not show which variables a macro's pragma makes thread-local. A macro whose
     * name has a universal character name can be written in two ways, so a search by name may miss
     * it. */
    static const char thread_local_pragma[] = "threadprivate";
    const char *universal = universal_name_in(text);
    if (text_has(text, thread_local_pragma))
        s->hidden = thread_local_pragma;
    if (universal)
        s->hidden = universal;
}

static void collect(CXFile file, CXSourceLocation *stack, unsigned depth, CXClientData data) {
    (void)stack;
    (void)depth;
    search *s = data;
    arena *a = s->converter->arena;
    if (is_of_system(s->converter, file))
        return;
    const file_directives found = directives_of_file(s->converter, file);
    for (unsigned i = 0; i < found.count; i++) {
        const ir_directive *d = &found.items[i];
        const char *end = d->text + strlen(d->text);
        const char *name = macro_name_defined(d->text, end), *after = name;
        if (d->kind != IR_DIRECTIVE_OTHER || name == NULL)
            continue;
        while (after < end && source_is_name_byte(*after))
            after++;
        VECTOR_PUSH(a, &s->all, ((definition){name, (size_t)(after - name), after}));
    }
}

/* May the replacement contain the operator _Pragma, directly, by another macro, or by pasting
 * names? */
static bool makes_pragma(const definition *it, const map *macros) {
    if (strstr(it->rest, pragma_operator) || strstr(it->rest, "##") || strstr(it->rest, "%:%:"))
        return true;
    size_t length;
    return source_find_name(it->rest, it->rest + strlen(it->rest), macros, &length) != NULL;
}

/* Does any definition contain the operator _Pragma? If not, no macro can produce it. */
static bool some_definition_names_operator(const search *s) {
    for (unsigned i = 0; i < s->all.count; i++)
        if (strstr(s->all.items[i].rest, pragma_operator))
            return true;
    return false;
}

void find_pragma_macros(converter *c) {
    search s = {.converter = c};
    clang_getInclusions(c->clang, search_file, &s);
    if (!s.is_found)
        return;
    clang_getInclusions(c->clang, collect, &s);
    if (!some_definition_names_operator(&s))
        return;
    map *macros = map_new(c->arena);
    for (bool has_grown = true; has_grown;) {
        has_grown = false;
        for (unsigned i = 0; i < s.all.count; i++) {
            const definition *it = &s.all.items[i];
            void **known = map_at(macros, it->name, it->length);
            if (*known == NULL && makes_pragma(it, macros)) {
                *map_at(macros, it->name, it->length) = c;
                has_grown = true;
            }
        }
    }
    c->unit->text.pragma_macros = macros;
    if (s.hidden)
        c->unit->text.unseen_word = s.hidden;
    c->unit->text.may_make_fenv_access = s.has_fenv_access;
}
