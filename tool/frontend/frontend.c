/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* One file through libclang: parse, translate, put in order. */
#include "frontend/frontend.h"

#include <stdlib.h>
#include <string.h>

#include "frontend/translation.h"

const char *frontend_version(arena *a) {
    CXString version = clang_getClangVersion();
    const char *text = arena_string(a, clang_getCString(version));
    clang_disposeString(version);
    return text;
}

static enum CXChildVisitResult top_level(CXCursor cursor, CXCursor parent, CXClientData data) {
    translation *t = data;
    (void)parent;
    if (!place_is_in_main_file(t, cursor))
        return CXChildVisit_Continue;
    if (clang_getCursorKind(cursor) == CXCursor_FunctionDecl && clang_isCursorDefinition(cursor)) {
        translate_function(t, cursor);
        translate_pending(t);
    } else if (clang_getCursorKind(cursor) == CXCursor_VarDecl) {
        translate_variable(t, cursor);
    }
    return CXChildVisit_Continue;
}

/* ---- errors -------------------------------------------------------------------------------- */

static void blame_function(translation *t, CXDiagnostic diagnostic) {
    CXFile file = NULL;
    unsigned offset = 0;
    clang_getExpansionLocation(clang_getDiagnosticLocation(diagnostic), &file, NULL, NULL, &offset);
    if (!file || !clang_File_isEqual(file, t->main_file))
        return;
    for (unsigned i = 0; i < t->function_list.count; i++) {
        ir_function *function = t->function_list.items[i];
        if (function->is_in_main_file && function->range.begin <= offset &&
            offset < function->range.end)
            function->has_errors = true;
    }
}

static void take_diagnostics(translation *t, frontend_result *result) {
    VECTOR(frontend_diagnostic) list = {0};
    const unsigned count = clang_getNumDiagnostics(t->clang);
    for (unsigned i = 0; i < count; i++) {
        CXDiagnostic diagnostic = clang_getDiagnostic(t->clang, i);
        const bool is_error = clang_getDiagnosticSeverity(diagnostic) >= CXDiagnostic_Error;
        const frontend_diagnostic item = {
            take_string(t, clang_formatDiagnostic(diagnostic, CXDiagnostic_DisplaySourceLocation |
                                                                  CXDiagnostic_DisplayColumn)),
            is_error};
        VECTOR_PUSH(t->arena, &list, item);
        if (is_error) {
            blame_function(t, diagnostic);
            t->unit->error_count++;
        }
        clang_disposeDiagnostic(diagnostic);
    }
    result->diagnostic_count = list.count;
    result->diagnostics = list.items;
}

/* ---- order --------------------------------------------------------------------------------- */

/* Bodies of the main file first, by place; then the others as they were met. */
static int by_place(const void *a, const void *b) {
    const ir_function *f = *(ir_function *const *)a, *g = *(ir_function *const *)b;
    const int first = f->is_in_main_file && f->body ? 0 : 1;
    const int second = g->is_in_main_file && g->body ? 0 : 1;
    if (first != second)
        return first - second;
    if (first == 0 && f->range.begin != g->range.begin)
        return f->range.begin < g->range.begin ? -1 : 1;
    return f->id < g->id ? -1 : f->id > g->id;
}

static void put_in_order(translation *t) {
    ir_unit *unit = t->unit;
    unit->function_count = t->function_list.count;
    unit->functions = t->function_list.items;
    if (unit->function_count)
        qsort(unit->functions, unit->function_count, sizeof *unit->functions, by_place);
    for (unsigned i = 0; i < unit->function_count; i++)
        unit->functions[i]->id = i;
    unit->variable_count = t->variable_list.count;
    unit->variables = t->variable_list.items;
}

/* ---- the whole ----------------------------------------------------------------------------- */

static void translate_unit(translation *t, frontend_result *result) {
    t->main_file = clang_getFile(t->clang, t->unit->source->path);
    t->types = map_new(t->arena);
    t->records = map_new(t->arena);
    t->fields = map_new(t->arena);
    t->variables = map_new(t->arena);
    t->functions = map_new(t->arena);
    clang_visitChildren(clang_getTranslationUnitCursor(t->clang), top_level, t);
    take_diagnostics(t, result);
    put_in_order(t);
    scan_directives(t->arena, t->unit);
}

frontend_result frontend_parse(arena *a, const source *src, unsigned flag_count,
                               const char *const *flags) {
    frontend_result result = {0};
    translation t = {.arena = a, .unit = ARENA_NEW(a, ir_unit)};
    t.unit->arena = a;
    t.unit->source = src;
    const flag_list arguments = frontend_flags(a, flag_count, flags, &t.unit->strict_aliasing);
    struct CXUnsavedFile file = {src->path, src->text, src->length};
    CXIndex index = clang_createIndex(0, 0);
    const enum CXErrorCode code = clang_parseTranslationUnit2(
        index, src->path, arguments.items, (int)arguments.count, &file, 1,
        CXTranslationUnit_KeepGoing | CXTranslationUnit_DetailedPreprocessingRecord, &t.clang);
    if (code == CXError_Success) {
        translate_unit(&t, &result);
        result.unit = t.unit;
        clang_disposeTranslationUnit(t.clang);
    }
    clang_disposeIndex(index);
    return result;
}
