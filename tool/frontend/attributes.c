/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Attributes of functions: pure, const, noreturn. */
#include <ctype.h>
#include <string.h>

#include "frontend/convert.h"

typedef struct reading {
    converter *converter;
    ir_function *function;
} reading;

/* clang has no cursor of its own for noreturn: the attribute's first word tells. */
static bool is_noreturn(converter *c, CXCursor attribute) {
    static const char *const words[] = {"noreturn", "__noreturn__", "_Noreturn"};
    file_text at = text_at(c, clang_getRangeStart(clang_getCursorExtent(attribute)));
    for (unsigned i = 0; i < sizeof words / sizeof words[0]; i++) {
        size_t length = strlen(words[i]);
        if (at.length > length && strncmp(at.text, words[i], length) == 0 &&
            !isalnum((unsigned char)at.text[length]) && at.text[length] != '_')
            return true;
    }
    return false;
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
    case CXCursor_UnexposedAttr:
        r->function->is_noreturn |= is_noreturn(r->converter, child);
        break;
    default:
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
