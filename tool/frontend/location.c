/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Converts clang's locations to offsets in the main file, also if macros are involved. */
#define _GNU_SOURCE /* for memmem */
#include <assert.h>
#include <string.h>

#include "frontend/convert.h"
#include "frontend/directives.h"
#include "frontend/flags.h"
#include "support/source.h"

typedef struct place {
    CXFile file;
    unsigned offset;
    bool is_from_macro;
} place;

static bool is_same_file(CXFile a, CXFile b) {
    return a == b || (a != NULL && b != NULL && clang_File_isEqual(a, b));
}

static unsigned end_of_expansion(const converter *c, uint32_t begin) {
    return (unsigned)(uintptr_t)map_get(c->expansions.ends, &begin, sizeof begin);
}

/* Returns the location of a token, or of the macro expansion that produced it. clang places all
 * tokens of an expansion at the expansion's beginning. So, once all expansions are known, a token
 * at another place in the main file comes from no macro. */
static place place_of(const converter *c, CXSourceLocation location) {
    place p = {0};
    CXFile spelled;
    unsigned spelled_offset;
    clang_getExpansionLocation(location, &p.file, NULL, NULL, &p.offset);
    if (c->expansions.are_known && p.file == c->main_file && end_of_expansion(c, p.offset) == 0)
        return p;
    clang_getSpellingLocation(location, &spelled, NULL, NULL, &spelled_offset);
    p.is_from_macro = p.offset != spelled_offset || !is_same_file(p.file, spelled);
    return p;
}

bool is_in_main_file(converter *c, CXSourceLocation location) {
    CXFile file;
    clang_getExpansionLocation(location, &file, NULL, NULL, NULL);
    return is_same_file(file, c->main_file);
}

static bool is_in_a_librarys_folder(const converter *c, const char *path) {
    const parse_flags *flags = c->compiler.flags;
    for (unsigned i = 0; i < flags->system_folders.count; i++)
        if (source_starts_with(path, flags->system_folders.items[i]))
            return true;
    return false;
}

static void visit_inclusion(CXFile file, CXSourceLocation *stack, unsigned depth,
                            CXClientData data) {
    (void)stack;
    converter *c = data;
    c->unit->text.includes_itself |= depth > 0 && is_same_file(file, c->main_file);
}

void find_own_inclusion(converter *c) {
    assert(c->main_file);
    clang_getInclusions(c->clang, visit_inclusion, c);
}

CXSourceRange extent_of(converter *c, CXCursor cursor) {
    const enum CXCursorKind kind = clang_getCursorKind(cursor);
    if (!clang_isExpression(kind) && !clang_isStatement(kind))
        return clang_getCursorExtent(cursor);
    const void *tree = cursor.data[1];
    cached_extent *kept = &c->extents[((uintptr_t)tree >> 4) % CACHED_EXTENTS];
    if (kept->tree != tree)
        *kept = (cached_extent){tree, clang_getCursorExtent(cursor)};
    return kept->extent;
}

/* ---- expansions ---------------------------------------------------------------------------- */

void note_expansion(converter *c, CXCursor expansion) {
    CXSourceRange extent = clang_getCursorExtent(expansion);
    place begin = place_of(c, clang_getRangeStart(extent));
    place end = place_of(c, clang_getRangeEnd(extent));
    if (begin.is_from_macro || end.is_from_macro || !is_same_file(begin.file, c->main_file))
        return;
    uint32_t from = begin.offset, to = end.offset;
    *map_at(c->expansions.ends, &from, sizeof from) = (void *)((uintptr_t)to + 1);
    *map_at(c->expansions.begins, &to, sizeof to) = (void *)((uintptr_t)from + 1);
}

/* ---- ranges -------------------------------------------------------------------------------- */

/* Corrects the end of a range whose last token comes from a macro. If the token is in a macro's
 * argument, clang gives a place in the argument. If it is in the macro's body, clang gives the end
 * of the expansion. */
static void find_end(const converter *c, place *end) {
    uint32_t offset = end->offset;
    if (!end->is_from_macro) {
        end->is_from_macro = map_get(c->expansions.begins, &offset, sizeof offset) != NULL;
        return;
    }
    unsigned known = end_of_expansion(c, offset);
    if (known > 0)
        end->offset = known - 1;
}

ir_range range_of(converter *c, CXSourceRange extent, bool *is_from_macro) {
    place begin = place_of(c, clang_getRangeStart(extent));
    place end = place_of(c, clang_getRangeEnd(extent));
    find_end(c, &end);
    *is_from_macro = begin.is_from_macro || end.is_from_macro;
    bool is_main = is_same_file(begin.file, c->main_file) && is_same_file(end.file, c->main_file);
    if (!is_main || begin.offset > end.offset || end.offset > c->unit->source->length)
        return (ir_range){0};
    return (ir_range){.begin = begin.offset, .end = end.offset};
}

void place_node(converter *c, ir_node *node, CXCursor cursor) {
    bool is_from_macro;
    node->range = range_of(c, extent_of(c, cursor), &is_from_macro);
    if (is_from_macro)
        node->flags |= IR_FROM_MACRO;
}

/* ---- texts --------------------------------------------------------------------------------- */

/* What is known about a file. To answer a question about a file, clang searches all macro
 * expansions of the program for it. So each question is asked once. */
typedef struct known_file {
    bool has_text, has_kind, is_scanned;
    file_text text;
    bool is_in_system_header;
    file_directives found;
} known_file;

static known_file *known_file_of(converter *c, CXFile file) {
    CXFileUniqueID id;
    memset(&id, 0, sizeof id);
    if (clang_getFileUniqueID(file, &id) != 0)
        memcpy(&id, &file, sizeof file);
    void **known = map_at(c->converted.files, &id, sizeof id);
    if (*known == NULL)
        *known = ARENA_NEW(c->arena, known_file);
    return *known;
}

static known_file *header_of(converter *c, CXFile file) {
    known_file *header = known_file_of(c, file);
    if (!header->has_text)
        header->text.text = clang_getFileContents(c->clang, file, &header->text.length);
    header->has_text = true;
    return header;
}

bool is_in_system_header(converter *c, CXFile file) {
    known_file *known = known_file_of(c, file);
    if (!known->has_kind)
        known->is_in_system_header =
            clang_Location_isInSystemHeader(clang_getLocationForOffset(c->clang, file, 0)) != 0;
    known->has_kind = true;
    return known->is_in_system_header;
}

bool is_of_system(converter *c, CXFile file) {
    if (!file || !is_in_system_header(c, file))
        return false;
    CXString name = clang_getFileName(file);
    const char *path = clang_getCString(name);
    const bool is_installed =
        path && source_starts_with(path, "/usr/") && !source_starts_with(path, "/usr/local/");
    const bool is_librarys = !is_installed && path && is_in_a_librarys_folder(c, path);
    clang_disposeString(name);
    return !is_librarys;
}

file_text text_of_file(converter *c, CXFile file) {
    if (file == NULL)
        return (file_text){0};
    if (is_same_file(file, c->main_file))
        return (file_text){.text = c->unit->source->text, .length = c->unit->source->length};
    return header_of(c, file)->text;
}

bool text_has(file_text file, const char *word) {
    return file.length > 0 && memmem(file.text, file.length, word, strlen(word)) != NULL;
}

file_directives directives_of_file(converter *c, CXFile file) {
    if (is_same_file(file, c->main_file))
        return (file_directives){c->unit->directives, c->unit->directive_count};
    known_file *header = header_of(c, file);
    if (!header->is_scanned && header->text.length > 0)
        header->found.items =
            directives_in(c->arena, header->text.text, header->text.length, &header->found.count);
    header->is_scanned = true;
    return header->found;
}

file_text text_at(converter *c, CXSourceLocation location) {
    CXFile file;
    unsigned offset;
    clang_getSpellingLocation(location, &file, NULL, NULL, &offset);
    file_text whole = text_of_file(c, file);
    if (whole.text == NULL || offset >= whole.length)
        return (file_text){0};
    return (file_text){.text = whole.text + offset, .length = whole.length - offset};
}

const char *plain_text(converter *c, CXCursor cursor) {
    bool is_from_macro;
    CXSourceRange extent = clang_getCursorExtent(cursor);
    ir_range range = range_of(c, extent, &is_from_macro);
    if (is_from_macro)
        return NULL;
    if (range.begin != range.end)
        return arena_copy(c->arena, c->unit->source->text + range.begin, range.end - range.begin);
    place begin = place_of(c, clang_getRangeStart(extent));
    place end = place_of(c, clang_getRangeEnd(extent));
    file_text file = text_of_file(c, begin.file);
    if (!is_same_file(begin.file, end.file) || file.text == NULL || begin.offset > end.offset ||
        end.offset > file.length)
        return NULL;
    return arena_copy(c->arena, file.text + begin.offset, end.offset - begin.offset);
}

const char *take_string(converter *c, CXString string) {
    const char *text = clang_getCString(string);
    text = arena_string(c->arena, text != NULL ? text : "");
    clang_disposeString(string);
    return text;
}
