/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Attributes of functions: pure, const, noreturn. */
#include <ctype.h>
#include <string.h>

#include "frontend/convert.h"

typedef struct reading {
    converter *converter;
    ir_function *function;
} reading;

/* clang has no cursors of their own for many attributes: the first word tells. */
static bool has_word(converter *c, CXCursor attribute, const char *const *words, unsigned count) {
    file_text at = text_at(c, clang_getRangeStart(clang_getCursorExtent(attribute)));
    for (unsigned i = 0; i < count; i++) {
        size_t length = strlen(words[i]);
        if (at.length > length && strncmp(at.text, words[i], length) == 0 &&
            !isalnum((unsigned char)at.text[length]) && at.text[length] != '_')
            return true;
    }
    return false;
}

static bool is_noreturn(converter *c, CXCursor attribute) {
    static const char *const words[] = {"noreturn", "__noreturn__", "_Noreturn"};
    return has_word(c, attribute, words, 3);
}

typedef struct cleanup_search {
    converter *converter;
    bool is_found;
} cleanup_search;

static enum CXChildVisitResult find_cleanup(CXCursor child, CXCursor parent, CXClientData data) {
    (void)parent;
    static const char *const words[] = {"cleanup", "__cleanup__"};
    cleanup_search *search = data;
    search->is_found = clang_getCursorKind(child) == CXCursor_UnexposedAttr &&
                       has_word(search->converter, child, words, 2);
    return search->is_found ? CXChildVisit_Break : CXChildVisit_Continue;
}

bool has_cleanup(converter *c, CXCursor declaration) {
    cleanup_search search = {.converter = c};
    clang_visitChildren(declaration, find_cleanup, &search);
    return search.is_found;
}

static enum CXChildVisitResult visit(CXCursor child, CXCursor parent, CXClientData data) {
    (void)parent;
    reading *r = data;
    switch (clang_getCursorKind(child)) {
    case CXCursor_PureAttr:
        r->function->is_attribute_pure = true;
        break;
    case CXCursor_ConstAttr:
        r->function->is_attribute_const = true;
        break;
    default:
        if (clang_isAttribute(clang_getCursorKind(child)))
            r->function->has_other_attributes = true;
        r->function->is_noreturn |= clang_getCursorKind(child) == CXCursor_UnexposedAttr &&
                                    is_noreturn(r->converter, child);
        break;
    }
    return CXChildVisit_Continue;
}

void read_attributes(converter *c, CXCursor declaration, ir_function *function) {
    reading r = {.converter = c, .function = function};
    clang_visitChildren(declaration, visit, &r);
    CXString spelling = clang_getTypeSpelling(clang_getCursorType(declaration));
    const char *text = clang_getCString(spelling);
    function->is_noreturn |= text != NULL && strstr(text, "__attribute__((noreturn))") != NULL;
    clang_disposeString(spelling);
}
