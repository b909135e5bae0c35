/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Handles loops in the program's own headers: selects the functions to convert, and records where
 * their loops are. Headers that clang treats as system headers do not count as the program's
 * own. */
#include <string.h>

#include "frontend/convert.h"
#include "ir/ir_position.h"

/* The file of the location, if it is neither the main file nor a system header; otherwise NULL. */
static CXFile own_header_at(converter *c, CXSourceLocation location, ir_position *at) {
    CXFile file;
    clang_getExpansionLocation(location, &file, &at->line, &at->column, NULL);
    if (file == NULL || clang_File_isEqual(file, c->main_file) ||
        clang_Location_isInSystemHeader(location))
        return NULL;
    return file;
}

/* May the function contain a loop, judging by the keywords in its text? A loop that a macro
 * produces is not found. */
static bool may_loop(converter *c, CXCursor definition) {
    CXSourceRange extent = clang_getCursorExtent(definition);
    CXFile begins, ends;
    unsigned from, to;
    clang_getExpansionLocation(clang_getRangeStart(extent), &begins, NULL, NULL, &from);
    clang_getExpansionLocation(clang_getRangeEnd(extent), &ends, NULL, NULL, &to);
    const file_text file = text_of_file(c, begins);
    if (!clang_File_isEqual(begins, ends) || from >= to || to > file.length)
        return true;
    const file_text text = {file.text + from, to - from};
    return text_has(text, "for") || text_has(text, "while") || text_has(text, "do");
}

/* Is the function named anywhere in the main file, perhaps in the initialiser of a table of
 * functions? */
static bool is_named_in_main_file(const converter *c, CXCursor definition) {
    CXString spelling = clang_getCursorSpelling(definition);
    const char *name = clang_getCString(spelling);
    const source *file = c->unit->source;
    const bool is_found = name != NULL && source_has_name(file->text, file->length, name);
    clang_disposeString(spelling);
    return is_found;
}

bool is_wanted_of_header(converter *c, CXCursor definition) {
    ir_position at;
    return own_header_at(c, clang_getCursorLocation(definition), &at) != NULL &&
           may_loop(c, definition) &&
           (clang_getCursorLinkage(definition) == CXLinkage_External ||
            is_named_in_main_file(c, definition));
}

void note_header_loop(converter *c, const ir_node *loop, CXCursor cursor) {
    ir_position at;
    CXFile file = own_header_at(c, clang_getCursorLocation(cursor), &at);
    if (file == NULL)
        return;
    at.file = name_of_file(c, file);
    while (strncmp(at.file, "./", 2) == 0) /* gcc's messages omit the "./" */
        at.file += 2;
    ir_position *kept = ARENA_NEW(c->arena, ir_position);
    *kept = at;
    *map_at(c->unit->text.header_loops, &loop, sizeof loop) = kept;
}

void note_inclusion(converter *c, CXCursor directive) {
    CXFile file = clang_getIncludedFile(directive), by;
    ir_inclusion found = {0};
    if (file == NULL || is_in_system_header(c, file))
        return;
    clang_getExpansionLocation(clang_getCursorLocation(directive), &by, NULL, NULL, &found.offset);
    found.is_in_main_file = by != NULL && clang_File_isEqual(by, c->main_file);
    found.file = name_of_file(c, file);
    if (found.file != NULL)
        VECTOR_PUSH(c->arena, &c->headers.inclusions, found);
}
