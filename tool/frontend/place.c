/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Where things stand: byte ranges of the main file, macros, tokens. */
#include <ctype.h>
#include <string.h>

#include "frontend/translation.h"

const char *take_string(translation *t, CXString string) {
    const char *text = clang_getCString(string);
    const char *copy = arena_string(t->arena, text ? text : "");
    clang_disposeString(string);
    return copy;
}

typedef struct collector {
    translation *t;
    cursor_list list;
} collector;

static enum CXChildVisitResult collect(CXCursor cursor, CXCursor parent, CXClientData data) {
    collector *c = data;
    (void)parent;
    VECTOR_PUSH(c->t->arena, &c->list, cursor);
    return CXChildVisit_Continue;
}

cursor_list children_of(translation *t, CXCursor cursor) {
    collector c = {.t = t};
    clang_visitChildren(cursor, collect, &c);
    return c.list;
}

typedef struct end {
    CXFile file;
    unsigned offset;
} end;

static end expansion_of(CXSourceLocation location) {
    end e = {0};
    clang_getExpansionLocation(location, &e.file, NULL, NULL, &e.offset);
    return e;
}

static end spelling_of(CXSourceLocation location) {
    end e = {0};
    clang_getSpellingLocation(location, &e.file, NULL, NULL, &e.offset);
    return e;
}

static bool is_main(const translation *t, CXFile file) {
    return file && clang_File_isEqual(file, t->main_file);
}

bool place_is_in_main_file(const translation *t, CXCursor cursor) {
    return is_main(t, expansion_of(clang_getCursorLocation(cursor)).file);
}

ir_range place_range(const translation *t, CXCursor cursor) {
    const CXSourceRange extent = clang_getCursorExtent(cursor);
    const end first = expansion_of(clang_getRangeStart(extent));
    const end last = expansion_of(clang_getRangeEnd(extent));
    if (!is_main(t, first.file) || !is_main(t, last.file) || last.offset < first.offset)
        return (ir_range){0};
    return (ir_range){first.offset, last.offset};
}

static bool is_plain_location(const translation *t, CXSourceLocation location) {
    const end expansion = expansion_of(location), spelling = spelling_of(location);
    end file = {0};
    clang_getFileLocation(location, &file.file, NULL, NULL, &file.offset);
    return is_main(t, expansion.file) && is_main(t, spelling.file) && is_main(t, file.file) &&
           expansion.offset == spelling.offset && expansion.offset == file.offset;
}

bool place_is_plain(const translation *t, CXCursor cursor) {
    const CXSourceRange extent = clang_getCursorExtent(cursor);
    return is_plain_location(t, clang_getRangeStart(extent)) &&
           is_plain_location(t, clang_getRangeEnd(extent));
}

/* The length of the number that begins a text: C's preprocessing number. */
static size_t number_length(const char *text, size_t limit) {
    size_t n = 0;
    while (n < limit) {
        const char c = text[n];
        const bool sign = (c == '+' || c == '-') && n > 0 && strchr("eEpP", text[n - 1]);
        if (!isalnum((unsigned char)c) && c != '.' && c != '_' && c != '\'' && !sign)
            break;
        n++;
    }
    return n;
}

const char *place_token(translation *t, CXCursor cursor) {
    const end at = spelling_of(clang_getRangeStart(clang_getCursorExtent(cursor)));
    size_t size = 0;
    const char *text = at.file ? clang_getFileContents(t->clang, at.file, &size) : NULL;
    if (!text || at.offset >= size)
        return NULL;
    const size_t length = number_length(text + at.offset, size - at.offset);
    return length ? arena_copy(t->arena, text + at.offset, length) : NULL;
}
