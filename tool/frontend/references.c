/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Finds the declaration to which each name in the functions' text refers, also for names that the
 * tree does not show (in types, lengths and sizeof). */
#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "frontend/convert.h"

struct reference_table {
    map *declared;   /* canonical declaration -> ir_declared */
    map *known;      /* any declaration -> ir_declared, to avoid the slower search for the
                      * canonical declaration */
    map *file_names; /* CXFile -> its path */
    VECTOR(ir_reference) items;
    VECTOR(ir_typed_place) typed_places;
};

struct reference_table *references_new(converter *c) {
    struct reference_table *table = ARENA_NEW(c->arena, struct reference_table);
    table->declared = map_new(c->arena);
    table->known = map_new(c->arena);
    table->file_names = map_new(c->arena);
    return table;
}

/* ---- declarations -------------------------------------------------------------------------- */

const char *name_of_file(converter *c, CXFile file) {
    if (file == NULL)
        return "";
    if (clang_File_isEqual(file, c->main_file))
        return NULL;
    void **known = map_at(c->references->file_names, &file, sizeof file);
    if (*known == NULL)
        *known = (void *)take_string(c, clang_getFileName(file));
    return *known;
}

/* Returns the structure, union or enumeration for which a typedef is a name, perhaps through
 * pointers and arrays. NULL if there is none. */
static const ir_declared *tag_of(converter *c, CXCursor declaration) {
    if (clang_getCursorKind(declaration) != CXCursor_TypedefDecl)
        return NULL;
    CXType type = clang_getCanonicalType(clang_getTypedefDeclUnderlyingType(declaration));
    for (;;) {
        if (type.kind == CXType_Pointer)
            type = clang_getPointeeType(type);
        else if (clang_getArrayElementType(type).kind != CXType_Invalid)
            type = clang_getArrayElementType(type);
        else
            break;
    }
    CXCursor tag = clang_getTypeDeclaration(type);
    return clang_isDeclaration(clang_getCursorKind(tag)) ? declared_of(c, tag) : NULL;
}

static const ir_declared *new_declared(converter *c, CXCursor first) {
    ir_declared *declared = ARENA_NEW(c->arena, ir_declared);
    CXFile file;
    unsigned offset;
    clang_getExpansionLocation(clang_getCursorLocation(first), &file, NULL, NULL, &offset);
    declared->name = take_string(c, clang_getCursorSpelling(first));
    declared->file = name_of_file(c, file);
    declared->offset = offset;
    const enum CXCursorKind kind = clang_getCursorKind(first);
    declared->is_external = (kind == CXCursor_VarDecl || kind == CXCursor_FunctionDecl) &&
                            clang_getCursorLinkage(first) == CXLinkage_External;
    declared->tag = tag_of(c, first);
    return declared;
}

const ir_declared *declared_of(converter *c, CXCursor declaration) {
    const void *own = declaration.data[0];
    const ir_declared *known = map_get(c->references->known, &own, sizeof own);
    if (known != NULL)
        return known;
    CXCursor first = clang_getCanonicalCursor(declaration);
    const void *key = first.data[0];
    known = map_get(c->references->declared, &key, sizeof key);
    if (known == NULL) {
        known = new_declared(c, first);
        *map_at(c->references->declared, &key, sizeof key) = (void *)known;
    }
    *map_at(c->references->known, &own, sizeof own) = (void *)known;
    return known;
}

/* ---- references ---------------------------------------------------------------------------- */

static bool is_typed(enum CXCursorKind kind) {
    return kind == CXCursor_DeclRefExpr || kind == CXCursor_ParenExpr ||
           kind == CXCursor_ArraySubscriptExpr;
}

static enum CXChildVisitResult visit_reference(CXCursor cursor, CXCursor parent,
                                               CXClientData data) {
    (void)parent;
    converter *c = data;
    const enum CXCursorKind kind = clang_getCursorKind(cursor);
    if (!is_typed(kind) && kind != CXCursor_TypeRef)
        return CXChildVisit_Recurse;
    CXFile file;
    unsigned offset;
    clang_getFileLocation(clang_getCursorLocation(cursor), &file, NULL, NULL, &offset);
    if (!clang_File_isEqual(file, c->main_file))
        return CXChildVisit_Recurse;
    if (is_typed(kind)) {
        const ir_typed_place found = {offset, convert_type(c, clang_getCursorType(cursor))};
        VECTOR_PUSH(c->arena, &c->references->typed_places, found);
    }
    CXCursor declaration = clang_getCursorReferenced(cursor);
    if ((kind == CXCursor_DeclRefExpr || kind == CXCursor_TypeRef) &&
        !clang_Cursor_isNull(declaration)) {
        const ir_reference found = {.offset = offset,
                                    .is_type = kind == CXCursor_TypeRef,
                                    .declared = declared_of(c, declaration)};
        VECTOR_PUSH(c->arena, &c->references->items, found);
    }
    return CXChildVisit_Recurse;
}

void note_references(converter *c, CXCursor body) {
    clang_visitChildren(body, visit_reference, c);
}

static int compare_offsets(uint32_t a, uint32_t b) {
    return a < b ? -1 : a > b;
}

static int compare_references(const void *left, const void *right) {
    return compare_offsets(((const ir_reference *)left)->offset,
                           ((const ir_reference *)right)->offset);
}

static int compare_typed_places(const void *left, const void *right) {
    return compare_offsets(((const ir_typed_place *)left)->offset,
                           ((const ir_typed_place *)right)->offset);
}

void finish_references(converter *c) {
    assert(!c->unit->references && !c->unit->typed_places); /* this function is called only
                                                             * once */
    struct reference_table *table = c->references;
    if (table->items.count > 0)
        qsort(table->items.items, table->items.count, sizeof *table->items.items,
              compare_references);
    if (table->typed_places.count > 0)
        qsort(table->typed_places.items, table->typed_places.count,
              sizeof *table->typed_places.items, compare_typed_places);
    c->unit->references = table->items.items;
    c->unit->reference_count = table->items.count;
    c->unit->typed_places = table->typed_places.items;
    c->unit->typed_place_count = table->typed_places.count;
}
