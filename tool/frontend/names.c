/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Collects the names that the program and its headers declare, because generated text must declare
 * other names. */
#include <string.h>

#include "frontend/convert.h"

static bool has_members(enum CXCursorKind kind) {
    return kind == CXCursor_StructDecl || kind == CXCursor_UnionDecl || kind == CXCursor_EnumDecl;
}

/* Does the cursor declare a non-static function `int name(void)` or `int name()`? */
static bool is_query(CXCursor declaration) {
    const CXType type = clang_getCursorType(declaration);
    const bool takes_nothing =
        type.kind == CXType_FunctionNoProto ||
        (type.kind == CXType_FunctionProto && clang_getNumArgTypes(type) == 0 &&
         clang_isFunctionTypeVariadic(type) == 0);
    return clang_getCursorKind(declaration) == CXCursor_FunctionDecl && takes_nothing &&
           clang_getResultType(type).kind == CXType_Int &&
           clang_getCursorLinkage(declaration) == CXLinkage_External;
}

/* Notes tags and enumerators that are declared inside a record. They belong to the scope around the
 * record (C17 6.2.1p7). */
static enum CXChildVisitResult visit_member(CXCursor member, CXCursor parent, CXClientData data) {
    (void)parent;
    const enum CXCursorKind kind = clang_getCursorKind(member);
    if (has_members(kind) || kind == CXCursor_EnumConstantDecl)
        note_name(data, member);
    return CXChildVisit_Continue;
}

void note_name(converter *c, CXCursor declaration) {
    CXString spelling = clang_getCursorSpelling(declaration);
    const char *name = clang_getCString(spelling);
    if (name != NULL && name[0] != 0) {
        void **known = map_at(c->unit->text.names, name, strlen(name));
        if (*known != IR_NAME_AS_OTHER)
            *known = is_query(declaration) ? IR_NAME_AS_QUERY : IR_NAME_AS_OTHER;
        if (c->function != NULL)
            *map_at(c->unit->text.inner_names, name, strlen(name)) = c->function;
    }
    clang_disposeString(spelling);
    if (has_members(clang_getCursorKind(declaration)))
        clang_visitChildren(declaration, visit_member, c);
}
