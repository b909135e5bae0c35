/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Collects the names of macros, wherever they are defined. Generated text that contains such a name
 * would be changed by the macro. */
#define _GNU_SOURCE /* for memmem */
#include <ctype.h>
#include <string.h>

#include "frontend/convert.h"
#include "frontend/directives.h"
#include "frontend/flags.h"

/* The first position at or after `at` that is no blank, comment or line splice. */
static const char *skip_spaces(const char *at, const char *end) {
    while (at < end) {
        const unsigned splice = splice_length(at, end);
        if (splice > 0) {
            at += splice;
        } else if (*at == ' ' || *at == '\t') {
            at++;
        } else if (end - at > 3 && at[0] == '/' && at[1] == '*') {
            const char *close = memmem(at + 2, (size_t)(end - at - 2), "*/", 2);
            at = close != NULL ? close + 2 : end;
        } else {
            break;
        }
    }
    return at;
}

/* Does the macro named at `at` expand to its own name, as in `#define SIGINT SIGINT`? */
static bool expands_to_itself(file_text at, const char *name, size_t length) {
    const char *end = at.text + at.length;
    if (at.length <= length || strncmp(at.text, name, length) != 0)
        return false;
    const char *body = skip_spaces(at.text + length, end);
    if ((size_t)(end - body) < length || strncmp(body, name, length) != 0)
        return false;
    body = skip_spaces(body + length, end);
    return body == end || *body == '\n' || *body == '\r';
}

static void note(map *macros, const char *name, size_t length, bool is_function_like) {
    void **known = map_at(macros, name, length);
    if (*known != IR_MACRO_AS_OBJECT)
        *known = is_function_like ? IR_MACRO_AS_FUNCTION : IR_MACRO_AS_OBJECT;
}

/* May the macro expand to its own name? Looking up the macro's definition is the most expensive
 * step here. Headers define thousands of macros in capitals, and few of them expand to themselves.
 * So the answer for macros in capitals outside of the main file is always false. */
static bool may_expand_to_itself(CXSourceLocation location, const char *name) {
    for (const char *p = name; *p; p++)
        if (islower((unsigned char)*p))
            return true;
    return clang_Location_isFromMainFile(location) != 0;
}

static bool is_built_in(CXSourceLocation location) {
    CXString file;
    clang_getPresumedLocation(location, &file, NULL, NULL);
    const char *name = clang_getCString(file);
    const bool is_own = name != NULL && strcmp(name, "<built-in>") == 0;
    clang_disposeString(file);
    return is_own;
}

/* Is the macro predefined, by the user's compiler or by clang, and so not the program's own? Also
 * adds to parsers_own each macro that clang predefines but the user's compiler does not. That is
 * known only if flags->predefined is set. */
static bool is_own_of_compiler(converter *c, CXSourceLocation location, const char *name,
                               size_t length) {
    const bool is_predefined = c->compiler.flags->predefined != NULL &&
                               map_get(c->compiler.flags->predefined, name, length);
    if (is_predefined)
        return true;
    if (!is_built_in(location))
        return false;
    if (c->compiler.flags->predefined != NULL)
        note(c->compiler.parsers_own, name, length, false);
    return true;
}

void note_macro(converter *c, CXCursor definition) {
    CXString text = clang_getCursorSpelling(definition);
    const char *name = clang_getCString(text);
    const size_t length = strlen(name);
    const bool is_function_like = clang_Cursor_isMacroFunctionLike(definition) != 0;
    const CXSourceLocation location = clang_getCursorLocation(definition);
    if (is_function_like || !may_expand_to_itself(location, name) ||
        !expands_to_itself(text_at(c, location), name, length))
        note(c->unit->text.macros, name, length, is_function_like);
    if (!c->has_begun && !is_own_of_compiler(c, location, name, length))
        note(c->unit->text.macros_before, name, length, is_function_like);
    clang_disposeString(text);
}

const char *macro_name_defined(const char *at, const char *end) {
    static const char *const marks[] = {"#", "%:", "?\?="};
    static const char word[] = "define";
    for (unsigned i = 0; i < sizeof marks / sizeof *marks; i++) {
        const size_t length = strlen(marks[i]);
        if ((size_t)(end - at) < length || strncmp(at, marks[i], length) != 0)
            continue;
        const char *name = skip_spaces(at + length, end);
        if ((size_t)(end - name) < sizeof word || strncmp(name, word, sizeof word - 1) != 0)
            return NULL;
        name += sizeof word - 1;
        return source_is_name_byte(*name) ? NULL : skip_spaces(name, end);
    }
    return NULL;
}

/* clang does not show definitions in a branch that it does not compile, but another compiler may
 * compile the branch. Names that begin with __ are left out: compilers define them, and programs
 * define them only for compilers that do not. */
void note_macros_of_directives(converter *c) {
    for (unsigned i = 0; i < c->unit->directive_count; i++) {
        const ir_directive *directive = &c->unit->directives[i];
        if (directive->kind != IR_DIRECTIVE_OTHER || directive->text == NULL)
            continue;
        const char *end = directive->text + strlen(directive->text);
        const char *name = macro_name_defined(directive->text, end), *after = name;
        if (name == NULL)
            continue;
        while (after < end && source_is_name_byte(*after))
            after++;
        const size_t length = (size_t)(after - name);
        const file_text at = {.text = name, .length = (size_t)(end - name)};
        if (length > 0 && strncmp(name, "__", 2) != 0 && !expands_to_itself(at, name, length))
            note(c->unit->text.macros, name, length, after < end && *after == '(');
    }
}
