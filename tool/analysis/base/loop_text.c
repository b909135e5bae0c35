/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/loop_text.h"

#include <assert.h>
#include <string.h>

#include "analysis/base/openmp_directive.h"

unsigned loop_text_first_directive(const ir_unit *unit, uint32_t offset) {
    unsigned low = 0, high = unit->directive_count;
    while (low < high) {
        const unsigned middle = low + (high - low) / 2;
        if (unit->directives[middle].range.begin < offset)
            low = middle + 1;
        else
            high = middle;
    }
    assert(low == unit->directive_count || unit->directives[low].range.begin >= offset);
    assert(low == 0 || unit->directives[low - 1].range.begin < offset);
    return low;
}

bool directives_name(const ir_unit *unit, ir_range range, const char *word) {
    for (unsigned i = loop_text_first_directive(unit, range.begin);
         i < unit->directive_count && unit->directives[i].range.begin < range.end; i++)
        if (unit->directives[i].text && strstr(unit->directives[i].text, word))
            return true;
    return false;
}

bool file_names(const ir_unit *unit, const char *word) {
    for (unsigned i = 0; i < unit->text.header_pragma_count; i++)
        if (strstr(unit->text.header_pragmas[i], word))
            return true;
    return directives_name(unit, (ir_range){0, UINT32_MAX}, word);
}

uint32_t loop_text_end_of_branch(const ir_unit *unit, unsigned number) {
    assert(number < unit->directive_count);
    const ir_directive *d = &unit->directives[number];
    return d->is_skipped && number + 1 < unit->directive_count ? d[1].range.begin : d->range.end;
}

/* ---- above the loop ------------------------------------------------------------------------ */

static bool is_blank(const ir_unit *unit, uint32_t begin, uint32_t end) {
    return source_skip_blanks(unit->source, begin, end) >= end;
}

/* Index of the #if to which the #endif with index `last` belongs; `last` if it has none. */
static unsigned first_of_group(const ir_unit *unit, unsigned last) {
    assert(unit->directives[last].kind == IR_DIRECTIVE_ENDIF);
    unsigned depth = 0;
    for (unsigned i = last;; i--) {
        depth += unit->directives[i].kind == IR_DIRECTIVE_ENDIF;
        if (unit->directives[i].kind == IR_DIRECTIVE_IF && --depth == 0)
            return i;
        if (i == 0)
            return last;
    }
}

static bool compiles_only_pragmas(const ir_unit *unit, unsigned first, unsigned last) {
    for (unsigned i = first; i <= last; i++) {
        const ir_directive *d = &unit->directives[i];
        if (d->kind == IR_DIRECTIVE_OTHER)
            return false;
        if (i < last && !d->is_skipped && !is_blank(unit, d->range.end, d[1].range.begin))
            return false;
    }
    return first < last;
}

/* If `text` begins with the word, the text after it and the blanks that follow; otherwise NULL. */
static const char *after_word(const char *text, const char *word) {
    const size_t length = strlen(word);
    if (strncmp(text, word, length) != 0 || source_is_name_byte(text[length]))
        return NULL;
    text += length;
    return text + strspn(text, " \t");
}

/* Is it an OpenMP directive that applies to no statement? */
static bool stands_alone(const ir_directive *d) {
    static const char *const words[] = {"barrier", "flush", "taskwait", "taskyield"};
    const char *at = d->text && d->text[0] == '#' ? d->text + 1 + strspn(d->text + 1, " \t") : NULL;
    at = at ? after_word(at, "pragma") : NULL;
    at = at ? after_word(at, "omp") : NULL;
    for (size_t i = 0; at && i < sizeof words / sizeof *words; i++)
        if (after_word(at, words[i]))
            return true;
    return false;
}

uint32_t loop_text_begin(const ir_unit *unit, const ir_node *loop) {
    uint32_t begin = loop->range.begin;
    unsigned next = unit->source ? loop_text_first_directive(unit, begin) : 0;
    while (next > 0) {
        unsigned first = next - 1;
        const ir_directive *d = &unit->directives[first];
        if (!is_blank(unit, d->range.end, begin))
            break;
        if (d->kind == IR_DIRECTIVE_ENDIF) {
            first = first_of_group(unit, next - 1);
            if (!compiles_only_pragmas(unit, first, next - 1))
                break;
        } else if (d->kind != IR_DIRECTIVE_PRAGMA || stands_alone(d)) {
            break;
        }
        next = first;
        begin = unit->directives[first].range.begin;
    }
    assert(begin <= loop->range.begin);
    return begin;
}

/* ---- in the loop --------------------------------------------------------------------------- */

static bool is_about_speed(const char *pragma) {
    static const char *const words[] = {"ivdep",  "unroll",   "nounroll", "loop",
                                        "vector", "novector", "simd"};
    if (pragma[0] != '#')
        return false;
    const char *at = after_word(pragma + 1 + strspn(pragma + 1, " \t"), "pragma");
    const char *rest = at ? after_word(at, "GCC") : NULL;
    rest = rest || !at ? rest : after_word(at, "clang");
    at = rest ? rest : at;
    for (size_t i = 0; at && i < sizeof words / sizeof *words; i++)
        if (after_word(at, words[i]))
            return true;
    return false;
}

/* May the directive change the meaning of macros? */
static bool is_about_macros(const ir_directive *d) {
    return d->text && (strstr(d->text, "push_macro") || strstr(d->text, "pop_macro"));
}

bool directive_is_ignored_openmp(const ir_unit *unit, const ir_directive *d) {
    return !unit->dialect.has_openmp && directive_is_openmp_pragma(d);
}

bool directive_can_be_left_out(const ir_unit *unit, const ir_directive *d) {
    return directive_is_conditional(d) || (d->is_skipped && !is_about_macros(d)) ||
           directive_is_ignored_openmp(unit, d) ||
           (unit->dialect.replaces_openmp && directive_is_openmp_pragma(d)) ||
           (d->kind == IR_DIRECTIVE_PRAGMA && d->text && is_about_speed(d->text));
}

/* Does the directive test _OPENMP? The output is compiled with OpenMP even if this compilation is
 * not. A macro of the program that depends on _OPENMP, such as HAVE_OPENMP, is treated like any
 * other: if its value differs, the original loop is used. */
static bool tests_openmp(const ir_directive *d) {
    static const char name[] = "_OPENMP";
    for (const char *at = d->text; at && (at = strstr(at, name)); at += sizeof name - 1)
        if ((at == d->text || !source_is_name_byte(at[-1])) &&
            !source_is_name_byte(at[sizeof name - 1]))
            return true;
    return false;
}

/* A directive between the loop's last expression and the semicolon; NULL if there is none. */
static const ir_directive *directive_before_semicolon(const ir_unit *unit, const ir_node *loop) {
    const ir_node *last = loop;
    while (last->child_count > 0 && last->kind != IR_DO &&
           (ir_is_loop(last) || last->kind == IR_IF || last->kind == IR_SWITCH ||
            last->kind == IR_LABEL))
        last = last->children[last->child_count - 1];
    if (!unit->source || last->kind == IR_BLOCK || last->flags & IR_FROM_MACRO)
        return NULL;
    const uint32_t end = source_skip_blanks(unit->source, loop->range.end, unit->source->length);
    const unsigned next = loop_text_first_directive(unit, end);
    const bool is_there = next < unit->directive_count && unit->directives[next].range.begin == end;
    return is_there && unit->source->text[loop->range.end - 1] != ';' ? &unit->directives[next]
                                                                      : NULL;
}

const ir_directive *loop_text_obstacle(const ir_unit *unit, const ir_node *loop) {
    const ir_directive *d = NULL;
    unsigned depth = 0;
    for (unsigned i = loop_text_first_directive(unit, loop_text_begin(unit, loop));
         i < unit->directive_count && unit->directives[i].range.begin < loop->range.end; i++) {
        d = &unit->directives[i];
        const bool is_above = d->range.end <= loop->range.begin;
        if (d->kind == IR_DIRECTIVE_OTHER ||
            (d->kind == IR_DIRECTIVE_PRAGMA && !is_above && !directive_can_be_left_out(unit, d)) ||
            (d->kind == IR_DIRECTIVE_ELSE && depth == 0) ||
            (d->kind == IR_DIRECTIVE_ENDIF && depth == 0) ||
            (unit->dialect.has_openmp && !unit->dialect.replaces_openmp &&
             directive_is_conditional(d) && tests_openmp(d)))
            return d;
        depth += d->kind == IR_DIRECTIVE_IF;
        depth -= d->kind == IR_DIRECTIVE_ENDIF;
    }
    return depth > 0 ? d : directive_before_semicolon(unit, loop);
}

bool loop_text_has_branches(const ir_unit *unit, const ir_node *loop) {
    for (unsigned i = loop_text_first_directive(unit, loop_text_begin(unit, loop));
         i < unit->directive_count && unit->directives[i].range.begin < loop->range.end; i++)
        if (directive_is_conditional(&unit->directives[i]))
            return true;
    return false;
}

/* ---- pragmas from macros, and those in functions --------------------------------------------- */

/* Is a name split over two lines at this byte? A search for the name would miss it. */
static bool splits_a_name(const char *text, uint32_t at) {
    assert(at > 0);
    return text[at] == '\\' && (text[at + 1] == '\n' || text[at + 1] == '\r') &&
           source_is_name_byte(text[at - 1]);
}

const char *text_pragma_macro(arena *a, const ir_unit *unit, ir_range range) {
    if (!unit->text.pragma_macros || !unit->source || range.end <= range.begin)
        return NULL;
    const char *text = unit->source->text;
    assert(range.end <= unit->source->length);
    for (uint32_t at = range.begin; at < range.end; at++)
        if (at > range.begin && splits_a_name(text, at))
            return "\\";
    size_t length;
    const char *name =
        source_find_name(text + range.begin, text + range.end, unit->text.pragma_macros, &length);
    return name ? arena_copy(a, name, length) : NULL;
}

bool directive_is_openmp(const ir_directive *d) {
    return (d->text && strstr(d->text, "omp") && strstr(d->text, "ragma")) || tests_openmp(d);
}

const ir_directive *loop_text_openmp_above(const ir_unit *unit, const ir_node *loop) {
    const uint32_t text_begin = loop_text_begin(unit, loop);
    uint32_t to = loop->range.begin;
    for (unsigned i = loop_text_first_directive(unit, to); i-- > 0;) {
        const ir_directive *d = &unit->directives[i];
        if (!d->is_skipped && source_skip_blanks(unit->source, d->range.end, to) < to)
            return NULL;
        const bool is_compiled = !d->is_skipped || d->range.begin < text_begin;
        if (d->kind == IR_DIRECTIVE_PRAGMA && is_compiled && directive_is_openmp(d))
            return d;
        to = d->range.begin;
    }
    return NULL;
}

bool function_has_ignored_openmp(const ir_unit *unit, const ir_function *function) {
    if (unit->dialect.has_openmp || !function->is_in_main_file)
        return false;
    if (file_names(unit, "threadprivate"))
        return true; /* with OpenMP, each thread would have its own copy of these variables */
    for (unsigned i = loop_text_first_directive(unit, function->range.begin);
         i < unit->directive_count && unit->directives[i].range.begin < function->range.end; i++)
        if (directive_is_openmp(&unit->directives[i]))
            return true;
    return false;
}

bool loop_text_depends_on_openmp(const ir_unit *unit, const ir_function *function,
                                 const ir_node *loop) {
    if (!unit->dialect.has_openmp)
        return function_has_ignored_openmp(unit, function);
    for (unsigned i = loop_text_first_directive(unit, loop_text_begin(unit, loop));
         i < unit->directive_count && unit->directives[i].range.begin < loop->range.end; i++)
        if (directive_is_openmp(&unit->directives[i]))
            return true;
    return loop_text_openmp_above(unit, loop) != NULL;
}

/* An OpenMP pragma in the program's headers, or "_Pragma" if a macro may expand to one; NULL if
 * there is neither. Used for functions of headers, whose text is not available. */
static const char *openmp_of_headers(const ir_unit *unit) {
    for (unsigned i = 0; i < unit->text.header_pragma_count; i++)
        if (strstr(unit->text.header_pragmas[i], "omp"))
            return unit->text.header_pragmas[i];
    return unit->text.pragma_macros ? "_Pragma" : NULL;
}

const char *text_openmp_in(arena *a, const ir_unit *unit, const ir_function *function) {
    const ir_range range = function->range;
    if (!function->is_in_main_file)
        return function->is_from_system ? NULL : openmp_of_headers(unit);
    if (!unit->source)
        return NULL;
    for (unsigned i = loop_text_first_directive(unit, range.begin);
         i < unit->directive_count && unit->directives[i].range.begin < range.end; i++) {
        const ir_directive *d = &unit->directives[i];
        if (d->is_skipped)
            continue;
        if (d->kind == IR_DIRECTIVE_PRAGMA && directive_is_openmp(d))
            return d->text;
        if (strstr(d->text, "include") && openmp_of_headers(unit))
            return d->text;
    }
    return text_pragma_macro(a, unit, range);
}
