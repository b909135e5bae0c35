/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Attributes, of functions mostly: pure, const, noreturn, weak; alias, may_alias. */
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

typedef struct attribute_search {
    converter *converter;
    const char *const *words;
    unsigned count;
    bool is_found;
} attribute_search;

static enum CXChildVisitResult find_attribute(CXCursor child, CXCursor parent, CXClientData data) {
    (void)parent;
    attribute_search *search = data;
    search->is_found = clang_getCursorKind(child) == CXCursor_UnexposedAttr &&
                       has_word(search->converter, child, search->words, search->count);
    return search->is_found ? CXChildVisit_Break : CXChildVisit_Continue;
}

/* Has the declaration an attribute of one of these names? */
static bool has_attribute(converter *c, CXCursor declaration, const char *const *words,
                          unsigned count) {
    attribute_search search = {.converter = c, .words = words, .count = count};
    clang_visitChildren(declaration, find_attribute, &search);
    return search.is_found;
}

bool has_cleanup(converter *c, CXCursor declaration) {
    static const char *const words[] = {"cleanup", "__cleanup__"};
    return has_attribute(c, declaration, words, 2);
}

static enum CXChildVisitResult find_label(CXCursor child, CXCursor parent, CXClientData data) {
    (void)parent;
    bool *is_found = data;
    *is_found = clang_getCursorKind(child) == CXCursor_AsmLabelAttr;
    return *is_found ? CXChildVisit_Break : CXChildVisit_Continue;
}

bool has_other_name(converter *c, CXCursor declaration) {
    static const char *const words[] = {"alias", "__alias__", "weakref", "__weakref__"};
    bool is_found = false;
    clang_visitChildren(declaration, find_label, &is_found);
    return is_found || has_attribute(c, declaration, words, 4);
}

bool is_under_may_alias(converter *c, CXCursor declaration) {
    static const char *const words[] = {"may_alias", "__may_alias__"};
    return has_attribute(c, declaration, words, 2);
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
    static const char *const replaceable[] = {"weak", "__weak__", "ifunc", "__ifunc__"};
    reading r = {.converter = c, .function = function};
    function->is_weak |= has_attribute(c, declaration, replaceable, 4);
    clang_visitChildren(declaration, visit, &r);
    CXString spelling = clang_getTypeSpelling(clang_getCursorType(declaration));
    const char *text = clang_getCString(spelling);
    function->is_noreturn |= text != NULL && strstr(text, "__attribute__((noreturn))") != NULL;
    clang_disposeString(spelling);
}
