/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/place.h"

#include <assert.h>
#include <string.h>

#include "plan/macros.h"
#include "support/attributes.h"

bool is_pragma_of(const ir_directive *d, const char *whose) {
    const char *at = d->text ? strstr(d->text, "pragma") : NULL;
    at = at ? at + strlen("pragma") : NULL;
    at = at ? at + strspn(at, " \t") : NULL;
    return at && source_starts_with(at, whose);
}

bool has_directive(const ir_unit *unit, uint32_t begin, uint32_t end, bool pragmas_only) {
    assert(begin <= end);
    for (unsigned i = 0; i < unit->directive_count; i++) {
        const ir_directive *directive = &unit->directives[i];
        if (directive->range.end > begin && directive->range.begin < end &&
            (!pragmas_only || directive->kind == IR_DIRECTIVE_PRAGMA))
            return true;
    }
    return false;
}

bool holds_word(const source *file, uint32_t begin, uint32_t end, const char *word) {
    assert(begin <= end && end <= file->length);
    const size_t length = strlen(word);
    for (uint32_t at = begin; at + length <= end; at++)
        if (memcmp(file->text + at, word, length) == 0)
            return true;
    return false;
}

/** Positions in the file after a token, or 0 if there is none. */
typedef struct token_ends {
    uint32_t last;        /* the end of the last token */
    uint32_t declaration; /* the end of the last ; or } outside of parentheses */
} token_ends;

/** Returns the position after the last function body that ends before `end`, or the beginning of
 *  the file. Searches for declarations begin there. The text before it does not matter, and reading
 *  it for each function would be slow in a long file. */
static uint32_t last_body_before(const ir_unit *unit, uint32_t end) {
    const source *file = unit->source;
    uint32_t last = source_starts_with(file->text, "\xef\xbb\xbf") ? 3 : 0;
    for (unsigned i = 0; i < unit->function_count; i++) {
        const ir_function *f = unit->functions[i];
        if (f->is_in_main_file && f->body && f->range.end <= end && f->range.end > last &&
            file->text[f->range.end - 1] == '}')
            last = f->range.end;
    }
    assert(last <= end);
    return last;
}

/** The ends of tokens before `end`; directives and comments do not count as tokens. */
static token_ends tokens_before(const ir_unit *unit, uint32_t end) {
    const source *file = unit->source;
    unsigned next = 0, depth = 0;
    uint32_t at = last_body_before(unit, end);
    token_ends found = {0, 0};
    if (at > 0 && file->text[at - 1] == '}')
        found = (token_ends){at, at};
    while ((at = source_skip_blanks(file, at, end)) < end) {
        while (next < unit->directive_count && unit->directives[next].range.end <= at)
            next++;
        if (next < unit->directive_count && unit->directives[next].range.begin <= at) {
            at = unit->directives[next].range.end;
            continue;
        }
        const char c = file->text[at];
        depth += c == '(';
        depth -= c == ')' && depth > 0;
        at = c == '"' || c == '\'' ? source_skip_quoted(file, at, end) : at + 1;
        found.last = at;
        if (depth == 0 && (c == ';' || c == '}'))
            found.declaration = at;
    }
    assert(found.declaration <= found.last && found.last <= end);
    return found;
}

/** Is there a pragma, other than redcc's, in bytes [begin, end)? Such a pragma may apply to the
 * text after it. `omp threadprivate` does not count, because it names the variables to which it
 * applies. */
static bool has_pragma_of_others(const ir_unit *unit, uint32_t begin, uint32_t end) {
    assert(begin <= end);
    for (unsigned i = 0; i < unit->directive_count; i++) {
        const ir_directive *d = &unit->directives[i];
        if (d->range.end > begin && d->range.begin < end && d->kind == IR_DIRECTIVE_PRAGMA &&
            !is_pragma_of(d, "redcc") &&
            !(is_pragma_of(d, "omp") && strstr(d->text, "threadprivate")))
            return true;
    }
    return false;
}

/** Does a macro expand to a whole function that begins in bytes [begin, end)? */
static bool is_made_by_macro(const ir_unit *unit, uint32_t begin, uint32_t end) {
    assert(begin <= end);
    for (unsigned i = 0; i < unit->function_count; i++) {
        const ir_function *other = unit->functions[i];
        if (other->is_in_main_file && other->body && other->range.begin >= begin &&
            other->range.begin < end)
            return true;
    }
    return false;
}

/** Returns the position for declarations before the function; UINT32_MAX if there is none. The
 *  function may begin with text outside of its range, such as a macro's name. */
static uint32_t place_of(const ir_unit *unit, const ir_function *function) {
    const token_ends before = tokens_before(unit, function->range.begin);
    if (before.last == before.declaration)
        return has_pragma_of_others(unit, before.last, function->range.begin)
                   ? UINT32_MAX
                   : function->range.begin;
    if (is_made_by_macro(unit, before.declaration, function->range.begin))
        return function->range.begin;
    return before.declaration == 0 ||
                   has_directive(unit, before.declaration, function->range.begin, false)
               ? UINT32_MAX
               : before.declaration;
}

bool has_place_in_front(const ir_unit *unit, const ir_function *function) {
    const source *file = unit->source;
    const uint32_t begin = function->range.begin;
    if (!function->is_in_main_file || function->has_other_attributes ||
        function->range.end <= begin || begin >= function->body->range.begin ||
        unit->text.includes_itself || unit->text.names_optimize ||
        !attributes_are_harmless(file->text + begin, file->text + function->body->range.begin))
        return false;
    return place_of(unit, function) != UINT32_MAX;
}

bool place_in_front(const ir_unit *unit, const ir_function *function, uint32_t *place) {
    const char *text = unit->source->text;
    const uint32_t begin = place_of(unit, function);
    assert(begin <= function->range.begin);
    *place = begin;
    while (*place > 0 && (text[*place - 1] == ' ' || text[*place - 1] == '\t'))
        --*place;
    if (*place == 0 || text[*place - 1] == '\n')
        return false;
    *place = begin;
    return true;
}
