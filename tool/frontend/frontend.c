/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "frontend/frontend.h"

#include <string.h>

#include "frontend/convert.h"
#include "frontend/directives.h"
#include "frontend/flags.h"

/* Trees are converted by recursion, DEEPEST_NODE levels at most. */
enum { STACK_SIZE = 64 << 20 };

/* ---- parsing ------------------------------------------------------------------------------- */

static bool is_incomplete(CXTranslationUnit clang) {
    bool has_fatal_error = false;
    unsigned count = clang_getNumDiagnostics(clang);
    for (unsigned i = 0; i < count && !has_fatal_error; i++) {
        CXDiagnostic diagnostic = clang_getDiagnostic(clang, i);
        has_fatal_error = clang_getDiagnosticSeverity(diagnostic) == CXDiagnostic_Fatal;
        clang_disposeDiagnostic(diagnostic);
    }
    return has_fatal_error;
}

static CXTranslationUnit parse(CXIndex index, const source *src, const char *name,
                               const parse_flags *flags) {
    struct CXUnsavedFile file = {.Filename = name, .Contents = src->text, .Length = src->length};
    CXTranslationUnit clang = NULL;
    enum CXErrorCode status = clang_parseTranslationUnit2(
        index, name, flags->items.items, (int)flags->items.count, &file, 1,
        CXTranslationUnit_KeepGoing | CXTranslationUnit_DetailedPreprocessingRecord, &clang);
    return status == CXError_Success ? clang : NULL;
}

static frontend_diagnostic convert_diagnostic(arena *a, CXDiagnostic diagnostic) {
    CXString text = clang_formatDiagnostic(diagnostic, CXDiagnostic_DisplaySourceLocation |
                                                           CXDiagnostic_DisplayColumn);
    frontend_diagnostic converted = {
        .text = arena_string(a, clang_getCString(text)),
        .is_error = clang_getDiagnosticSeverity(diagnostic) >= CXDiagnostic_Error,
    };
    clang_disposeString(text);
    return converted;
}

static void convert_diagnostics(arena *a, CXTranslationUnit clang, frontend_result *result) {
    unsigned count = clang_getNumDiagnostics(clang);
    frontend_diagnostic *diagnostics = ARENA_ARRAY(a, frontend_diagnostic, count + 1u);
    for (unsigned i = 0; i < count; i++) {
        CXDiagnostic diagnostic = clang_getDiagnostic(clang, i);
        diagnostics[i] = convert_diagnostic(a, diagnostic);
        clang_disposeDiagnostic(diagnostic);
    }
    result->diagnostic_count = count;
    result->diagnostics = diagnostics;
}

/* ---- conversion ---------------------------------------------------------------------------- */

static enum CXChildVisitResult visit_expansion(CXCursor cursor, CXCursor parent,
                                               CXClientData data) {
    (void)parent;
    if (clang_getCursorKind(cursor) == CXCursor_MacroExpansion)
        note_expansion(data, cursor);
    return CXChildVisit_Continue;
}

/* Functions of the main file; those of headers follow where they are used. */
static enum CXChildVisitResult visit_function(CXCursor cursor, CXCursor parent, CXClientData data) {
    (void)parent;
    converter *c = data;
    if (clang_getCursorKind(cursor) == CXCursor_FunctionDecl && clang_isCursorDefinition(cursor) &&
        is_in_main_file(c, clang_getCursorLocation(cursor)))
        convert_function(c, cursor);
    return CXChildVisit_Continue;
}

static enum CXChildVisitResult find_body(CXCursor child, CXCursor parent, CXClientData data) {
    (void)parent;
    if (clang_getCursorKind(child) != CXCursor_CompoundStmt)
        return CXChildVisit_Continue;
    *(CXCursor *)data = child;
    return CXChildVisit_Break;
}

static void convert_body(converter *c, const function_body *pending) {
    CXCursor body = clang_getNullCursor();
    clang_visitChildren(pending->definition, find_body, &body);
    if (clang_Cursor_isNull(body))
        return;
    c->function = pending->function;
    c->depth = 0;
    c->scratch = arena_new();
    pending->function->body = convert_statement(c, body);
    arena_free(c->scratch);
    c->scratch = NULL;
    c->function = NULL;
}

/* Runs on a thread of its own, for its stack. */
static void convert_unit(void *data) {
    converter *c = data;
    CXCursor unit = clang_getTranslationUnitCursor(c->clang);
    clang_visitChildren(unit, visit_expansion, c);
    mark_functions_with_errors(c);
    clang_visitChildren(unit, visit_function, c);
    for (unsigned i = 0; i < c->pending.count; i++) { /* grows as functions are met */
        function_body pending = c->pending.items[i];
        convert_body(c, &pending);
    }
    find_directives(c->arena, c->unit);
    finish_unit(c);
}

static ir_unit *convert(arena *a, const source *src, const char *name, CXTranslationUnit clang) {
    ir_unit *unit = ARENA_NEW(a, ir_unit);
    unit->arena = a;
    unit->source = src;
    converter c = {
        .arena = a,
        .unit = unit,
        .clang = clang,
        .main_file = clang_getFile(clang, name),
        .types = map_new(a),
        .records = map_new(a),
        .fields = map_new(a),
        .variables = map_new(a),
        .functions = map_new(a),
        .functions_with_errors = map_new(a),
        .pointers = map_new(a),
        .files = map_new(a),
        .expansion_ends = map_new(a),
        .expansion_begins = map_new(a),
    };
    clang_executeOnThread(convert_unit, &c, STACK_SIZE);
    return unit;
}

frontend_result frontend_parse(arena *a, const source *src, unsigned flag_count,
                               const char *const *flags) {
    frontend_result result = {0};
    const char *name = strcmp(src->path, "-") == 0 ? "<stdin>" : src->path;
    parse_flags chosen = choose_flags(a, flag_count, flags);
    CXIndex index = clang_createIndex(0, 0);
    CXTranslationUnit clang = parse(index, src, name, &chosen);
    if (clang == NULL) { /* a machine flag that only the user's compiler knows? */
        remove_machine_flags(&chosen);
        clang = parse(index, src, name, &chosen);
    }
    if (clang != NULL && is_incomplete(clang) && add_gcc_headers(a, &chosen)) {
        clang_disposeTranslationUnit(clang);
        clang = parse(index, src, name, &chosen);
    }
    if (clang != NULL) {
        convert_diagnostics(a, clang, &result);
        result.unit = convert(a, src, name, clang);
        result.unit->strict_aliasing = chosen.strict_aliasing;
        clang_disposeTranslationUnit(clang);
    }
    clang_disposeIndex(index);
    return result;
}

const char *frontend_version(arena *a) {
    CXString version = clang_getClangVersion();
    const char *text = arena_string(a, clang_getCString(version));
    clang_disposeString(version);
    return text;
}
