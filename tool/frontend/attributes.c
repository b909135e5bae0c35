/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Reads attributes, mostly of functions: pure, const, noreturn, weak, ifunc, alias, weakref,
 * may_alias, cleanup. Also reads the names in #pragma weak and threadprivate. */
#include <string.h>

#include "frontend/convert.h"
#include "support/attributes.h"
#include "support/source.h"

static enum CXChildVisitResult find_unexposed(CXCursor child, CXCursor parent, CXClientData data) {
    (void)parent;
    bool *is_found = data;
    *is_found = clang_getCursorKind(child) == CXCursor_UnexposedAttr;
    return *is_found ? CXChildVisit_Break : CXChildVisit_Continue;
}

/* May the declaration have an attribute with one of these names? libclang has no cursors for many
 * attributes, and the source may write them in many ways (in a namespace, by macros, across line
 * splices). This function therefore searches clang's own print of the declaration. False positives
 * are possible, because other text in the print may match; false negatives are not. */
static bool has_attribute(CXCursor declaration, const char *const *words, unsigned count) {
    bool has_unexposed = false;
    clang_visitChildren(declaration, find_unexposed, &has_unexposed);
    if (!has_unexposed)
        return false;
    CXPrintingPolicy policy = clang_getCursorPrintingPolicy(declaration);
    clang_PrintingPolicy_setProperty(policy, CXPrintingPolicy_TerseOutput, 1);
    CXString print = clang_getCursorPrettyPrinted(declaration, policy);
    const char *text = clang_getCString(print);
    bool is_found = text == NULL;
    for (unsigned i = 0; i < count && !is_found; i++)
        is_found = source_has_word(text, strlen(text), words[i]);
    clang_disposeString(print);
    clang_PrintingPolicy_dispose(policy);
    return is_found;
}

bool has_cleanup(CXCursor declaration) {
    static const char *const words[] = {"cleanup", "__cleanup__"};
    return has_attribute(declaration, words, 2);
}

/* Does an assembler label or `#pragma redefine_extname` give the declaration another symbol
 * name? */
static bool is_renamed(CXCursor declaration) {
    CXString mangled = clang_Cursor_getMangling(declaration);
    CXString spelled = clang_getCursorSpelling(declaration);
    const char *name = clang_getCString(mangled);
    const bool is_same = name == NULL || strcmp(name, clang_getCString(spelled)) == 0;
    clang_disposeString(mangled);
    clang_disposeString(spelled);
    return !is_same;
}

bool has_other_name(const converter *c, CXCursor declaration) {
    static const char *const words[] = {"alias", "__alias__", "weakref", "__weakref__"};
    if (clang_getCursorLinkage(declaration) == CXLinkage_External &&
        (c->has_assembler || is_renamed(declaration)))
        return true;
    return has_attribute(declaration, words, 4);
}

bool has_may_alias(CXCursor declaration) {
    static const char *const words[] = {"may_alias", "__may_alias__"};
    return has_attribute(declaration, words, 2);
}

/* Is the attribute known to be harmless? Its name is looked up at the spelling location, because it
 * may be in a macro's definition. */
static bool is_harmless(CXCursor attribute) {
    CXFile file;
    unsigned offset;
    size_t size = 0, length = 0;
    const CXSourceLocation begin = clang_getRangeStart(clang_getCursorExtent(attribute));
    clang_getSpellingLocation(begin, &file, NULL, NULL, &offset);
    if (file == NULL)
        return false; /* the name is made of pasted tokens */
    CXTranslationUnit unit = clang_Cursor_getTranslationUnit(attribute);
    const char *text = clang_getFileContents(unit, file, &size);
    while (text != NULL && offset + length < size && source_is_word_byte(text[offset + length]))
        length++;
    return text != NULL && attribute_is_harmless(text + offset, length);
}

static enum CXChildVisitResult visit(CXCursor child, CXCursor parent, CXClientData data) {
    (void)parent;
    ir_function *function = data;
    switch (clang_getCursorKind(child)) {
    case CXCursor_PureAttr:
        function->is_attribute_pure = true;
        break;
    case CXCursor_ConstAttr:
        function->is_attribute_const = true;
        break;
    default:
        if (clang_isAttribute(clang_getCursorKind(child))) {
            function->has_attributes = true;
            function->has_other_attributes |= !is_harmless(child);
        }
        break;
    }
    return CXChildVisit_Continue;
}

static bool has_other_symbol(CXCursor declaration) {
    static const char *const words[] = {"alias", "__alias__", "weakref", "__weakref__"};
    return (clang_getCursorLinkage(declaration) == CXLinkage_External && is_renamed(declaration)) ||
           has_attribute(declaration, words, 4);
}

void read_attributes(converter *c, CXCursor declaration, ir_function *function) {
    static const char *const replaceable[] = {"weak", "__weak__", "ifunc", "__ifunc__"};
    static const char *const not_returning[] = {"noreturn", "__noreturn__", "_Noreturn"};
    function->linkage.is_weak |= has_attribute(declaration, replaceable, 4);
    function->is_noreturn |= has_attribute(declaration, not_returning, 3);
    function->linkage.is_renamed |= has_other_symbol(declaration);
    function->linkage.is_hidden |= clang_getCursorLinkage(declaration) != CXLinkage_External ||
                                   clang_getCursorVisibility(declaration) != CXVisibility_Default ||
                                   clang_Cursor_isFunctionInlined(declaration);
    if (!function->is_from_system) {
        CXFile file;
        clang_getExpansionLocation(clang_getCursorLocation(declaration), &file, NULL, NULL, NULL);
        function->is_from_system = is_of_system(c, file);
    }
    clang_visitChildren(declaration, visit, function);
    CXString spelling = clang_getTypeSpelling(clang_getCursorType(declaration));
    const char *text = clang_getCString(spelling);
    function->is_noreturn |= text != NULL && strstr(text, "__attribute__((noreturn))") != NULL;
    clang_disposeString(spelling);
}

/* ---- names in pragmas ---------------------------------------------------------------------- */

static bool is_named(const char *name, const char *text, size_t length) {
    return strncmp(name, text, length) == 0 && name[length] == 0;
}

static void mark_weak(converter *c, const char *name, size_t length) {
    for (unsigned i = 0; i < c->mains.count; i++)
        c->mains.items[i]->linkage.is_weak |= is_named(c->mains.items[i]->name, name, length);
    for (unsigned i = 0; i < c->found.count; i++)
        c->found.items[i]->has_other_name |= is_named(c->found.items[i]->name, name, length);
}

static void mark_thread_local(converter *c, const char *name, size_t length) {
    for (unsigned i = 0; i < c->found.count; i++) {
        ir_variable *v = c->found.items[i];
        if (v->storage != IR_LOCAL && v->storage != IR_PARAMETER && is_named(v->name, name, length))
            v->storage = IR_THREAD_LOCAL;
    }
}

static bool follows_pragma(const char *text, const char *word) {
    const char *at = word;
    while (at > text && at[-1] != '\n')
        at--;
    const char *pragma = strstr(at, "ragma"); /* also matches _Pragma */
    return pragma != NULL && pragma < word;
}

/* Calls `mark` for each name between `word` and the end of its line, if a pragma precedes `word` on
 * that line. */
static void mark_names_after(converter *c, const char *text, const char *word,
                             void (*mark)(converter *c, const char *name, size_t length)) {
    for (const char *at = strstr(text, word); at != NULL; at = strstr(at, word)) {
        const bool is_pragma = follows_pragma(text, at);
        at += strlen(word);
        while (is_pragma && *at != 0 && *at != '\n') {
            size_t length = 0;
            while (source_is_word_byte(at[length]))
                length++;
            if (length > 0)
                mark(c, at, length);
            at += length > 0 ? length : 1;
        }
    }
}

static void mark_names_in(converter *c, const char *text) {
    mark_names_after(c, text, "weak", mark_weak);
    if (c->unit->dialect.has_openmp)
        mark_names_after(c, text, "threadprivate", mark_thread_local);
}

void mark_names_in_pragmas(converter *c) {
    mark_names_in(c, c->unit->source->text);
    for (unsigned i = 0; i < c->unit->text.header_pragma_count; i++)
        mark_names_in(c, c->unit->text.header_pragmas[i]);
}
