/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/place.h"

#include <string.h>

#include "plan/macros.h"
#include "support/attributes.h"

bool has_directive(const ir_unit *unit, uint32_t begin, uint32_t end, bool pragmas_only) {
    for (unsigned i = 0; i < unit->directive_count; i++) {
        const ir_directive *directive = &unit->directives[i];
        if (directive->range.end > begin && directive->range.begin < end &&
            (!pragmas_only || directive->kind == IR_DIRECTIVE_PRAGMA))
            return true;
    }
    return false;
}

bool holds_word(const source *file, uint32_t begin, uint32_t end, const char *word) {
    const size_t length = strlen(word);
    for (uint32_t at = begin; at + length <= end; at++)
        if (memcmp(file->text + at, word, length) == 0)
            return true;
    return false;
}

/** The last byte before `end` that is neither blank nor part of a directive or comment: its place
 *  plus 1; 0: there is none. */
static uint32_t end_of_last_token(const ir_unit *unit, uint32_t end) {
    const source *file = unit->source;
    unsigned next = 0;
    uint32_t last = 0, at = source_starts_with(file->text, "\xef\xbb\xbf") ? 3 : 0;
    while ((at = source_skip_blanks(file, at, end)) < end) {
        while (next < unit->directive_count && unit->directives[next].range.end <= at)
            next++;
        if (next < unit->directive_count && unit->directives[next].range.begin <= at) {
            at = unit->directives[next].range.end;
            continue;
        }
        const bool is_quoted = file->text[at] == '"' || file->text[at] == '\'';
        at = is_quoted ? source_skip_quoted(file, at, end) : at + 1;
        last = at;
    }
    return last;
}

bool has_place_in_front(arena *a, const ir_unit *unit, const ir_function *function) {
    const source *file = unit->source;
    const uint32_t begin = function->range.begin;
    if (!function->is_in_main_file || function->has_other_attributes ||
        function->range.end <= begin || begin >= function->body->range.begin ||
        unit->text.includes_itself || unit->text.names_optimize ||
        !attributes_are_harmless(file->text + begin, file->text + function->body->range.begin) ||
        macro_name_in(a, unit, file->text + begin, function->body->range.begin - begin))
        return false; /* a macro may make attributes, or another name each time */
    const uint32_t before = end_of_last_token(unit, begin);
    if (before > 0 && !strchr(";}", file->text[before - 1]))
        return false;
    return !has_directive(unit, before, begin, true);
}

bool place_in_front(const ir_unit *unit, const ir_function *function, uint32_t *place) {
    const char *text = unit->source->text;
    const uint32_t begin = function->range.begin;
    *place = begin;
    while (*place > 0 && (text[*place - 1] == ' ' || text[*place - 1] == '\t'))
        --*place;
    if (*place == 0 || text[*place - 1] == '\n')
        return false;
    *place = begin;
    return true;
}
