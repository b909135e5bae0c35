/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "redcc/headers_in_place.h"

#include <assert.h>
#include <string.h>

#include "driver/dependencies.h"
#include "driver/files.h"
#include "frontend/directives.h"
#include "ir/ir_position.h"

static const char *plain_name(const char *path) {
    while (strncmp(path, "./", 2) == 0)
        path += 2;
    return path;
}

/* ---- the header's text --------------------------------------------------------------------- */

/* Does the text name a macro whose value depends on the file, on the depth of inclusion, or on what
 * the parser has read before? */
static bool has_telling_word(const char *text) {
    static const char *const words[] = {"__FILE",      "__INCLUDE_LEVEL", "__BASE_FILE",
                                        "__COUNTER",   "__TIMESTAMP",     "__has_include",
                                        "__has_embed", "system_header",   "_Pragma",
                                        "REDCC",       "dependency",      "?\?/"};
    for (unsigned i = 0; i < sizeof words / sizeof *words; i++)
        if (strstr(text, words[i]))
            return true;
    return false;
}

/* The word of a directive and, in *rest, the text after it. */
static const char *directive_word(arena *a, const char *text, const char **rest) {
    if (*text != '#')
        return "";
    text += 1 + strspn(text + 1, " \t");
    const size_t length = strspn(text, "abcdefghijklmnopqrstuvwxyz_");
    *rest = text + length + strspn(text + length, " \t");
    return arena_copy(a, text, length);
}

static bool is_once(arena *a, const ir_directive *directive) {
    const char *rest = "";
    return strcmp(directive_word(a, directive->text, &rest), "pragma") == 0 &&
           strncmp(rest, "once", 4) == 0;
}

/* Does the directive mean the same in the including file? A compiler looks for "x.h" first in the
 * folder of the file that names it. `is_beside`: header and including file are in one folder. */
static bool directive_fits(arena *a, const ir_directive *directive, bool is_beside) {
    const char *rest = "";
    const char *word = directive_word(a, directive->text, &rest);
    static const char *const words[] = {"define", "undef",   "if",      "ifdef", "ifndef",
                                        "elif",   "else",    "endif",   "error", "warning",
                                        "pragma", "elifdef", "elifndef"};
    if (strcmp(word, "include") == 0)
        return *rest == '<' || (*rest == '"' && is_beside);
    for (unsigned i = 0; i < sizeof words / sizeof *words; i++)
        if (strcmp(word, words[i]) == 0)
            return true;
    return false;
}

/* Does the text before `end` end with a declaration? Otherwise it might end with a macro's name
 * that takes its arguments from the text after the directive. */
static bool ends_with_declaration(const char *text, uint32_t end, const ir_directive *directives,
                                  unsigned count) {
    char last = ';';
    unsigned next = 0;
    for (const char *at = text; at < text + end;) {
        while (next < count && text + directives[next].range.begin < at)
            next++;
        if (next < count && text + directives[next].range.begin == at &&
            directives[next].range.end > directives[next].range.begin) {
            at = text + directives[next].range.end;
            continue;
        }
        const char *after = piece_end(at, text + end);
        const bool is_comment = *at == '/' && after > at + 1;
        if (!is_comment && !strchr(" \t\n\f\v", *at))
            last = after[-1];
        at = after;
    }
    return last == ';' || last == '}';
}

static bool text_fits(arena *a, const source *header, const source *around) {
    const char *text = header->text;
    if (memchr(text, 0, header->length) || strchr(text, '\r') || strchr(around->text, '\r') ||
        strncmp(text, "\xEF\xBB\xBF", 3) == 0 || has_telling_word(text) ||
        (header->length > 0 && text[header->length - 1] == '\\') ||
        (header->length > 1 && text[header->length - 2] == '\\'))
        return false;
    unsigned count;
    const ir_directive *directives = directives_in(a, text, header->length, &count);
    const bool is_beside = strcmp(path_folder(a, plain_name(header->path)),
                                  path_folder(a, plain_name(around->path))) == 0;
    for (unsigned i = 0; i < count; i++)
        if (!directive_fits(a, &directives[i], is_beside))
            return false;
    return ends_with_declaration(text, header->length, directives, count);
}

/* ---- the directive ------------------------------------------------------------------------- */

/* Finds a directive `#include "x.h"`, with nothing after it, on the line around `offset`. Sets
 * *found to the directive's range. */
static bool find_directive(const ir_unit *unit, uint32_t offset, ir_range *found) {
    const source *s = unit->source;
    uint32_t begin = offset, end = offset;
    while (begin > 0 && s->text[begin - 1] != '\n')
        begin--;
    while (end < s->length && s->text[end] != '\n')
        end++;
    const char *at = s->text + begin + strspn(s->text + begin, " \t");
    uint32_t first = (uint32_t)(at - s->text);
    if (*at != '#')
        return false;
    at += 1 + strspn(at + 1, " \t");
    if (strncmp(at, "include", 7) != 0)
        return false;
    at += 7 + strspn(at + 7, " \t");
    const char *close = *at == '"' ? strchr(at + 1, '"') : NULL;
    if (!close || close >= s->text + end || close + 1 + strspn(close + 1, " \t") != s->text + end)
        return false;
    *found = (ir_range){first, end};
    return true;
}

/* Does the file or a header use __INCLUDE_LEVEL__? In a header's text that replaces its #include
 * directive, the level is lower by one. */
static bool names_level(arena *a, const ir_unit *unit) {
    static const char word[] = "__INCLUDE_LEVEL__";
    bool is_found = strstr(unit->source->text, word) != NULL;
    for (unsigned i = 0; i < unit->text.inclusion_count && !is_found; i++) {
        const char *wrong;
        const source *header = source_read(a, unit->text.inclusions[i].file, &wrong);
        is_found = !header || strstr(header->text, word);
    }
    return is_found;
}

/* Returns the only directive that includes the header, if it is in the main file. NULL if there are
 * several such directives, none, or it is in another file. */
static const ir_inclusion *only_inclusion(const ir_unit *unit, const char *header) {
    const ir_inclusion *only = NULL;
    for (unsigned i = 0; i < unit->text.inclusion_count; i++) {
        const ir_inclusion *it = &unit->text.inclusions[i];
        if (strcmp(plain_name(it->file), header) != 0)
            continue;
        if (only)
            return NULL;
        only = it;
    }
    return only && only->is_in_main_file ? only : NULL;
}

static bool find_use(arena *a, const ir_unit *unit, const char *header, header_use *use) {
    const ir_inclusion *only = only_inclusion(unit, header);
    const char *wrong;
    if (!only || strpbrk(only->file, "\"\\\n") || strpbrk(unit->source->path, "\"\\\n<") ||
        !find_directive(unit, only->offset, &use->directive))
        return false;
    use->name = header;
    use->file = source_read(a, only->file, &wrong);
    return use->file && text_fits(a, use->file, unit->source) &&
           !strpbrk(ir_position_of(unit, use->directive.begin).file, "\"\\\n") &&
           ends_with_declaration(unit->source->text, use->directive.begin, unit->directives,
                                 unit->directive_count);
}

/* ---- all ----------------------------------------------------------------------------------- */

/* The headers with refused loops. */
static map *headers_of_loops(arena *a, const ir_unit *unit, const analysis_result *analysed) {
    map *headers = map_new(a);
    for (unsigned i = 0; i < analysed->verdict_count; i++) {
        const ir_position *at = ir_position_in_header(unit, analysed->verdicts[i].loop);
        if (at && analysed->verdicts[i].why.id == REASON_IN_HEADER)
            *map_at(headers, plain_name(at->file), strlen(plain_name(at->file))) = headers;
    }
    return headers;
}

header_uses headers_that_fit(arena *a, const ir_unit *unit, const analysis_result *analysed) {
    const map *headers = headers_of_loops(a, unit, analysed);
    header_uses found = {0};
    for (unsigned i = 0; i < unit->text.inclusion_count; i++) {
        const char *name = plain_name(unit->text.inclusions[i].file);
        header_use use = {0};
        if (map_get(headers, name, strlen(name)) && find_use(a, unit, name, &use))
            VECTOR_PUSH(a, &found, use);
    }
    return found.count > 0 && names_level(a, unit) ? (header_uses){0} : found;
}

/* Appends the header's text, with an empty line for each `#pragma once`. */
static void add_text(arena *a, buffer *out, const source *header) {
    unsigned count;
    const ir_directive *directives = directives_in(a, header->text, header->length, &count);
    uint32_t copied = 0;
    for (unsigned i = 0; i < count; i++) {
        if (!is_once(a, &directives[i]))
            continue;
        buffer_append(out, header->text + copied, directives[i].range.begin - copied);
        copied = directives[i].range.begin;
        while (copied < directives[i].range.end && header->text[copied] != '\n')
            copied++;
    }
    buffer_append(out, header->text + copied, header->length - copied);
    if (header->length > 0 && header->text[header->length - 1] != '\n')
        buffer_byte(out, '\n');
}

/* Returns the header's name as the compiler writes it in __FILE__. For a header x.h in the current
 * folder, clang writes ./x.h. */
static const char *name_in_program(arena *a, const ir_unit *unit, const header_use *use,
                                   bool as_clang) {
    const bool is_here = !*path_folder(a, unit->source->path);
    return is_here && !as_clang ? plain_name(use->file->path) : use->file->path;
}

const source *headers_in_place(arena *a, const ir_unit *unit, const header_uses *headers,
                               bool as_clang) {
    const source *s = unit->source;
    buffer out = {0};
    uint32_t copied = 0;
    for (unsigned i = 0; i < headers->count; i++) {
        const header_use *use = &headers->items[i];
        const ir_position at = ir_position_of(unit, use->directive.begin);
        assert(copied <= use->directive.begin);
        buffer_append(&out, s->text + copied, use->directive.begin - copied);
        buffer_format(&out, "#line 1 \"%s\"%s\n", name_in_program(a, unit, use, as_clang),
                      DEPENDENCY_IN_PLACE);
        add_text(a, &out, use->file);
        buffer_format(&out, "#line %u \"%s\"", at.line + 1, at.file);
        copied = use->directive.end;
    }
    buffer_append(&out, s->text + copied, s->length - copied);
    const source *result = source_from_text(a, s->path, out.data, out.length);
    buffer_free(&out);
    return result;
}

bool header_is_used(const ir_unit *unit, const analysis_result *analysed, const reason *obstacles,
                    const char *header) {
    for (unsigned i = 0; i < analysed->verdict_count; i++) {
        const loop_verdict *verdict = &analysed->verdicts[i];
        if (verdict_is_written(verdict) && !(obstacles && obstacles[i].message) &&
            strcmp(plain_name(ir_position_of(unit, verdict->loop->range.begin).file), header) == 0)
            return true;
    }
    return false;
}

/* ---- reasons ------------------------------------------------------------------------------- */

static bool is_same_place(const ir_position *at, const ir_position *other) {
    return at->line == other->line && at->column == other->column &&
           strcmp(plain_name(at->file), plain_name(other->file)) == 0;
}

analysis_result with_reasons_in_place(arena *a, const ir_unit *unit, const analysis_result *found,
                                      const ir_unit *in_place, const analysis_result *known) {
    loop_verdict *verdicts = ARENA_ARRAY(a, loop_verdict, found->verdict_count + 1);
    for (unsigned i = 0; i < found->verdict_count; i++) {
        verdicts[i] = found->verdicts[i];
        const ir_position *at = ir_position_in_header(unit, verdicts[i].loop);
        for (unsigned k = 0; at && k < known->verdict_count; k++) {
            const loop_verdict *other = &known->verdicts[k];
            const ir_position place = ir_position_of(in_place, other->loop->range.begin);
            if (other->kind == VERDICT_REFUSE && is_same_place(at, &place)) {
                verdicts[i].why = other->why;
                verdicts[i].why.range = (ir_range){0};
            }
        }
    }
    return (analysis_result){found->verdict_count, verdicts};
}
