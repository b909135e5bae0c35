/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Finds functions with compiler errors. Ill-formed statements are missing from clang's tree without
 * a trace, so nothing in such a function may be analysed. */
#include <string.h>

#include "frontend/convert.h"

bool is_missing_header(CXDiagnostic diagnostic) {
    CXString spelling = clang_getDiagnosticSpelling(diagnostic);
    const char *text = clang_getCString(spelling);
    bool is_missing = clang_getDiagnosticSeverity(diagnostic) >= CXDiagnostic_Error &&
                      text != NULL && strstr(text, "file not found") != NULL;
    clang_disposeString(spelling);
    return is_missing;
}

/* The location of an error, or of an #include that leads to a file with an error. */
typedef struct error_place {
    CXFile file;
    unsigned offset;
} error_place;

typedef struct error_list {
    converter *converter;
    VECTOR(error_place) places;
    CXFile wanted;      /* a file with an error; the #include directives that lead to it are being
                         * searched */
    bool is_incomplete; /* a header is missing; any name in the file could have been one of its
                         * macros */
} error_list;

static bool is_same(CXFile a, CXFile b) {
    return a == b || (a != NULL && b != NULL && clang_File_isEqual(a, b));
}

static void add_place(error_list *list, CXSourceLocation location) {
    error_place place;
    clang_getExpansionLocation(location, &place.file, NULL, NULL, &place.offset);
    VECTOR_PUSH(list->converter->arena, &list->places, place);
}

/* Adds every #include that leads to the file with an error, directly or indirectly. */
static void visit_inclusion(CXFile file, CXSourceLocation *stack, unsigned length,
                            CXClientData data) {
    error_list *list = data;
    if (is_same(file, list->wanted))
        for (unsigned i = 0; i < length; i++)
            add_place(list, stack[i]);
}

static void add_error(error_list *list, CXDiagnostic diagnostic) {
    converter *c = list->converter;
    c->unit->error_count++;
    list->is_incomplete = list->is_incomplete || is_missing_header(diagnostic);
    add_place(list, clang_getDiagnosticLocation(diagnostic));
    list->wanted = list->places.items[list->places.count - 1].file;
    if (list->wanted != NULL && !is_same(list->wanted, c->main_file))
        clang_getInclusions(c->clang, visit_inclusion, list);
    unsigned ranges = clang_getDiagnosticNumRanges(diagnostic);
    for (unsigned i = 0; i < ranges; i++) {
        CXSourceRange range = clang_getDiagnosticRange(diagnostic, i);
        add_place(list, clang_getRangeStart(range));
        add_place(list, clang_getRangeEnd(range));
    }
}

static bool has_error(const error_list *list, CXCursor definition) {
    CXFile file;
    unsigned begin, end;
    CXSourceRange extent = clang_getCursorExtent(definition);
    clang_getExpansionLocation(clang_getRangeStart(extent), &file, NULL, NULL, &begin);
    clang_getExpansionLocation(clang_getRangeEnd(extent), NULL, NULL, NULL, &end);
    for (unsigned i = 0; i < list->places.count; i++) {
        const error_place *place = &list->places.items[i];
        if (place->offset >= begin && place->offset <= end && is_same(place->file, file))
            return true;
    }
    return list->is_incomplete;
}

static enum CXChildVisitResult visit_declaration(CXCursor cursor, CXCursor parent,
                                                 CXClientData data) {
    (void)parent;
    error_list *list = data;
    converter *c = list->converter;
    if (clang_getCursorKind(cursor) == CXCursor_FunctionDecl && has_error(list, cursor)) {
        const void *key = clang_getCanonicalCursor(cursor).data[0];
        *map_at(c->converted.functions_with_errors, &key, sizeof key) = c;
    }
    return CXChildVisit_Continue;
}

void mark_functions_with_errors(converter *c) {
    error_list list = {.converter = c};
    unsigned count = clang_getNumDiagnostics(c->clang);
    for (unsigned i = 0; i < count; i++) {
        CXDiagnostic diagnostic = clang_getDiagnostic(c->clang, i);
        if (clang_getDiagnosticSeverity(diagnostic) >= CXDiagnostic_Error)
            add_error(&list, diagnostic);
        clang_disposeDiagnostic(diagnostic);
    }
    if (list.places.count > 0)
        clang_visitChildren(clang_getTranslationUnitCursor(c->clang), visit_declaration, &list);
}
