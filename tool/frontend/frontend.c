/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "frontend/frontend.h"

#include <assert.h>
#include <malloc.h>
#include <stdlib.h>
#include <string.h>

#include "frontend/convert.h"
#include "frontend/directives.h"
#include "frontend/flags.h"
#include "frontend/lexing.h"
#include "ir/ir_text.h"

/* clang parses by recursion and needs about 10 KB per level of nesting. The system allocates only
 * the part of the stack that is used. */
enum { STACK_SIZE = 256 << 20 };

/* ---- parsing ------------------------------------------------------------------------------- */

typedef bool (*diagnostic_test)(CXDiagnostic diagnostic);

static bool any_diagnostic(CXTranslationUnit clang, diagnostic_test test) {
    bool is_found = false;
    unsigned count = clang_getNumDiagnostics(clang);
    for (unsigned i = 0; i < count && !is_found; i++) {
        CXDiagnostic diagnostic = clang_getDiagnostic(clang, i);
        is_found = test(diagnostic);
        clang_disposeDiagnostic(diagnostic);
    }
    return is_found;
}

/* Does the diagnostic report an error outside of all files? Then the error concerns the flags. */
static bool is_about_flags(CXDiagnostic diagnostic) {
    CXFile file;
    clang_getExpansionLocation(clang_getDiagnosticLocation(diagnostic), &file, NULL, NULL, NULL);
    return file == NULL && clang_getDiagnosticSeverity(diagnostic) >= CXDiagnostic_Error;
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

static CXTranslationUnit parse_again(CXTranslationUnit before, CXIndex index, const source *src,
                                     const char *name, const parse_flags *flags) {
    if (before != NULL)
        clang_disposeTranslationUnit(before);
    return parse(index, src, name, flags);
}

static frontend_diagnostic convert_diagnostic(arena *a, CXDiagnostic diagnostic, CXFile main_file) {
    CXFile file;
    unsigned offset;
    clang_getExpansionLocation(clang_getDiagnosticLocation(diagnostic), &file, NULL, NULL, &offset);
    CXString text = clang_formatDiagnostic(diagnostic, CXDiagnostic_DisplaySourceLocation |
                                                           CXDiagnostic_DisplayColumn);
    frontend_diagnostic converted = {
        .text = arena_string(a, clang_getCString(text)),
        .is_error = clang_getDiagnosticSeverity(diagnostic) >= CXDiagnostic_Error,
        .is_placed = file != NULL && clang_File_isEqual(file, main_file),
        .offset = offset,
    };
    clang_disposeString(text);
    return converted;
}

static void convert_diagnostics(arena *a, CXTranslationUnit clang, const char *name,
                                frontend_result *result) {
    CXFile main_file = clang_getFile(clang, name);
    unsigned count = clang_getNumDiagnostics(clang);
    frontend_diagnostic *diagnostics = ARENA_ARRAY(a, frontend_diagnostic, count + 1u);
    for (unsigned i = 0; i < count; i++) {
        CXDiagnostic diagnostic = clang_getDiagnostic(clang, i);
        diagnostics[i] = convert_diagnostic(a, diagnostic, main_file);
        clang_disposeDiagnostic(diagnostic);
    }
    result->diagnostic_count = count;
    result->diagnostics = diagnostics;
}

/* ---- conversion ---------------------------------------------------------------------------- */

static enum CXChildVisitResult visit_macro(CXCursor cursor, CXCursor parent, CXClientData data) {
    (void)parent;
    converter *c = data;
    const enum CXCursorKind kind = clang_getCursorKind(cursor);
    c->has_begun = c->has_begun || is_in_main_file(c, clang_getCursorLocation(cursor));
    if (kind == CXCursor_MacroExpansion)
        note_expansion(c, cursor);
    else if (kind == CXCursor_MacroDefinition)
        note_macro(c, cursor);
    else if (kind == CXCursor_InclusionDirective)
        note_inclusion(c, cursor);
    return CXChildVisit_Continue;
}

/* May the cursor be `asm("...");`, which libclang shows as a declaration of no specific kind? */
static bool is_assembler(CXCursor cursor) {
    if (clang_getCursorKind(cursor) != CXCursor_UnexposedDecl)
        return false;
    CXPrintingPolicy policy = clang_getCursorPrintingPolicy(cursor);
    CXString print = clang_getCursorPrettyPrinted(cursor, policy);
    const char *text = clang_getCString(print);
    const bool is_found = text == NULL || strstr(text, "asm") != NULL;
    clang_disposeString(print);
    clang_PrintingPolicy_dispose(policy);
    return is_found;
}

/* Converts the functions that the main file defines, and the functions of headers that
 * is_wanted_of_header selects. Any other function is converted when a converted function uses
 * it. */
static enum CXChildVisitResult visit_function(CXCursor cursor, CXCursor parent, CXClientData data) {
    (void)parent;
    converter *c = data;
    note_name(c, cursor);
    c->has_assembler |= is_assembler(cursor);
    if (clang_getCursorKind(cursor) == CXCursor_FunctionDecl && clang_isCursorDefinition(cursor) &&
        (is_in_main_file(c, clang_getCursorLocation(cursor)) || is_wanted_of_header(c, cursor)))
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

static bool is_plain_operator(CXCursor cursor) {
    const enum CXUnaryOperatorKind unary = clang_getCursorUnaryOperatorKind(cursor);
    const enum CXBinaryOperatorKind binary = clang_getCursorBinaryOperatorKind(cursor);
    return unary == CXUnaryOperator_Plus || unary == CXUnaryOperator_Minus ||
           unary == CXUnaryOperator_Not || unary == CXUnaryOperator_LNot ||
           (binary >= CXBinaryOperator_Mul && binary <= CXBinaryOperator_LOr);
}

/* Sets *is_found if the expression contains an operation other than arithmetic on variables and
 * constants. */
static enum CXChildVisitResult find_effect(CXCursor child, CXCursor parent, CXClientData data) {
    (void)parent;
    bool *is_found = data;
    switch (clang_getCursorKind(child)) {
    case CXCursor_DeclRefExpr:
    case CXCursor_IntegerLiteral:
    case CXCursor_CharacterLiteral:
    case CXCursor_ParenExpr:
    case CXCursor_UnexposedExpr: /* an implicit conversion; other unexposed expressions have parts
                                  * of other kinds */
    case CXCursor_CStyleCastExpr:
        return CXChildVisit_Recurse;
    case CXCursor_UnaryOperator:
    case CXCursor_BinaryOperator:
        *is_found = !is_plain_operator(child);
        break;
    default:
        *is_found = clang_isExpression(clang_getCursorKind(child)) != 0;
        break;
    }
    return *is_found ? CXChildVisit_Break : CXChildVisit_Recurse;
}

static bool computes_with_effect(CXCursor declaration) {
    bool is_found = false;
    clang_visitChildren(declaration, find_effect, &is_found);
    return is_found;
}

/* Puts opaque statements before those of the body, for the lengths in the parameters' types, as in
 * `double (*a)[m++]`. C evaluates these lengths when the function is entered (C17 6.9.1p10).
 * Lengths that have no effect are omitted. */
static void put_lengths_first(converter *c, CXCursor definition, ir_node *body) {
    const int count = clang_Cursor_getNumArguments(definition);
    for (int i = count - 1; i >= 0; i--) {
        CXCursor parameter = clang_Cursor_getArgument(definition, (unsigned)i);
        if (!has_variable_length(convert_type(c, clang_getCursorType(parameter))) ||
            !computes_with_effect(parameter))
            continue;
        ir_node **children = ARENA_ARRAY(c->arena, ir_node *, body->child_count + 1u);
        memcpy(children + 1, body->children, body->child_count * sizeof *children);
        children[0] = convert_lengths(c, parameter, "length in a parameter's type");
        children[0]->range = (ir_range){.begin = body->range.begin, .end = body->range.begin};
        body->children = children;
        body->child_count++;
    }
}

static void convert_body(converter *c, const function_body *pending) {
    CXCursor body = clang_getNullCursor();
    clang_visitChildren(pending->definition, find_body, &body);
    if (clang_Cursor_isNull(body))
        return;
    c->function = pending->function;
    c->depth = 0;
    pending->function->body = convert_statement(c, body);
    if (pending->function->is_in_main_file)
        note_references(c, body);
    if (pending->function->body->kind == IR_BLOCK)
        put_lengths_first(c, pending->definition, pending->function->body);
    arena_clear(c->scratch);
    c->function = NULL;
}

static void convert_unit(converter *c) {
    CXCursor unit = clang_getTranslationUnitCursor(c->clang);
    clang_visitChildren(unit, visit_macro, c);
    c->expansions.are_known = true;
    c->unit->text.inclusion_count = c->headers.inclusions.count;
    c->unit->text.inclusions = c->headers.inclusions.items;
    mark_functions_with_errors(c);
    clang_visitChildren(unit, visit_function, c);
    for (unsigned i = 0; i < c->pending.count; i++) { /* the list grows as functions are found */
        function_body pending = c->pending.items[i];
        convert_body(c, &pending);
    }
    find_directives(c->arena, c->unit);
    note_macros_of_directives(c);
    mark_skipped_directives(c);
    find_compiler_words(c);
    find_runtime_names(c);
    find_own_inclusion(c);
    find_header_pragmas(c);
    find_pragma_macros(c);
    mark_names_in_pragmas(c);
    finish_unit(c);
    finish_references(c);
}

static ir_unit *convert(arena *a, const source *src, const char *name, CXTranslationUnit clang,
                        const parse_flags *flags) {
    ir_unit *unit = ARENA_NEW(a, ir_unit);
    unit->dialect.has_openmp = flags->has_openmp; /* must be set before mark_names_in_pragmas */
    unit->arena = a;
    unit->source = src;
    unit->dialect.strict_aliasing = true;
    unit->dialect.wraps = flags->wraps; /* must be set before types are converted */
    unit->text.macros = map_new(a);
    unit->text.macros_before = map_new(a);
    unit->text.names = map_new(a);
    unit->text.inner_names = map_new(a);
    unit->text.header_loops = map_new(a);
    converter c = {
        .arena = a,
        .unit = unit,
        .clang = clang,
        .main_file = clang_getFile(clang, name),
        .converted = {.types = map_new(a),
                      .records = map_new(a),
                      .fields = map_new(a),
                      .variables = map_new(a),
                      .functions = map_new(a),
                      .functions_with_errors = map_new(a),
                      .pointers = map_new(a),
                      .files = map_new(a)},
        .expansions = {.ends = map_new(a), .begins = map_new(a)},
        .compiler = {.flags = flags, .parsers_own = map_new(a)},
    };
    c.scratch = arena_new();
    c.references = references_new(&c);
    convert_unit(&c);
    arena_free(c.scratch);
    return unit;
}

/* ---- all ----------------------------------------------------------------------------------- */

typedef struct task {
    arena *arena;
    const source *source;
    unsigned flag_count;
    const char *const *flags;
    bool only_diagnoses;
    bool is_parsed;
    frontend_result result;
} task;

static CXTranslationUnit parse_with_fallbacks(task *t, CXIndex index, const char *name,
                                              parse_flags *chosen) {
    CXTranslationUnit clang = parse(index, t->source, name, chosen);
    if (clang == NULL || any_diagnostic(clang, is_about_flags)) {
        /* perhaps a machine flag that only the user's compiler knows */
        remove_machine_flags(chosen);
        clang = parse_again(clang, index, t->source, name, chosen);
    }
    if (clang != NULL && any_diagnostic(clang, is_missing_header) &&
        add_gcc_headers(t->arena, chosen))
        clang = parse_again(clang, index, t->source, name, chosen);
    return clang;
}

/* Does the text contain the attribute may_alias? libclang does not show this attribute in a cast or
 * typeof. The attribute has no arguments, so a name `may_alias` before a parenthesis is a
 * function's. */
static bool names_may_alias(const char *text) {
    static const char word[] = "may_alias";
    for (const char *at = strstr(text, word); at != NULL; at = strstr(at + 1, word))
        if (at[sizeof word - 1] != '(')
            return true;
    return false;
}

static void apply_flags(ir_unit *unit, const parse_flags *chosen) {
    if (chosen->unseen != NULL)
        unit->text.unseen_word = chosen->unseen;
    unit->dialect.refusing_option = chosen->refusing;
    if (chosen->inexact != NULL && has_floating_work(unit))
        unit->dialect.inexact_option = chosen->inexact;
    unit->dialect.is_c89 = chosen->is_c89;
    unit->dialect.is_sanitized = chosen->is_sanitized;
    unit->dialect.math_errno = chosen->math_errno;
}

static void convert_parsed(task *t, const char *name, CXTranslationUnit clang,
                           const parse_flags *chosen) {
    ir_unit *unit = convert(t->arena, t->source, name, clang, chosen);
    /* Strict aliasing is disabled for the whole file even if an attribute or a pragma disables it
     * only for a part. This costs only speed. */
    const bool is_disabled_in_text =
        strstr(t->source->text, "no-strict-aliasing") != NULL || names_may_alias(t->source->text);
    unit->dialect.strict_aliasing &= chosen->strict_aliasing && !is_disabled_in_text;
    apply_flags(unit, chosen);
    for (unsigned i = 0; i < t->flag_count; i++) {
        unit->text.names_counter |= strstr(t->flags[i], "__COUNTER__") != NULL;
        if (strstr(t->flags[i], "_Pragma") != NULL)
            unit->text.unseen_word = "_Pragma";
    }
    if (chosen->is_c23 && lexing_has_digit_separator(t->source->text, t->source->length))
        unit->text.unseen_word = "a digit separator";
    assert(ir_check_parsed(t->arena, unit) == NULL);
    t->result.unit = unit;
}

static void run(void *data) {
    task *t = data;
    const char *name = strcmp(t->source->path, "-") == 0 ? "<stdin>" : t->source->path;
    parse_flags chosen = choose_flags(t->arena, t->flag_count, t->flags);
    CXIndex index = clang_createIndex(0, 0);
    CXTranslationUnit clang = parse_with_fallbacks(t, index, name, &chosen);
    t->is_parsed = clang != NULL;
    if (clang != NULL) {
        convert_diagnostics(t->arena, clang, name, &t->result);
        list_inclusions(t->arena, clang, &t->result);
        if (!t->only_diagnoses)
            convert_parsed(t, name, clang, &chosen);
        clang_disposeTranslationUnit(clang);
    }
    clang_disposeIndex(index);
}

/* Makes all threads share one heap that grows in large steps. A thread's own heap would need a
 * system call for every 128 KB. */
static void use_one_heap(void) {
#ifdef __GLIBC__
    enum { GROWTH = 16 << 20 };
    mallopt(M_ARENA_MAX, 1);
    mallopt(M_TOP_PAD, GROWTH);
#endif
}

static void run_task(task *t) {
    /* By default, libclang parses on a separate thread with a stack of 8 MB. A few hundred nested
     * parentheses would overflow it and end the process. */
    setenv("LIBCLANG_NOTHREADS", "1", 0);
    use_one_heap();
    clang_executeOnThread(run, t, STACK_SIZE);
}

frontend_result frontend_parse(arena *a, const source *src, unsigned flag_count,
                               const char *const *flags) {
    task t = {.arena = a, .source = src, .flag_count = flag_count, .flags = flags};
    run_task(&t);
    return t.result;
}

bool frontend_diagnose(arena *a, const source *src, unsigned flag_count, const char *const *flags,
                       frontend_result *result) {
    task t = {.arena = a,
              .source = src,
              .flag_count = flag_count,
              .flags = flags,
              .only_diagnoses = true};
    run_task(&t);
    *result = t.result;
    return t.is_parsed;
}

const char *frontend_version(arena *a) {
    CXString version = clang_getClangVersion();
    const char *text = arena_string(a, clang_getCString(version));
    clang_disposeString(version);
    return text;
}
