/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Converts variables and functions, each when it is first used. */
#include "frontend/convert.h"

/* The range from the name to the end of the declarator, including its initialiser. */
static ir_range range_from_name(converter *c, CXCursor declaration) {
    bool is_from_macro;
    CXSourceLocation name = clang_getCursorLocation(declaration);
    CXSourceLocation end = clang_getRangeEnd(clang_getCursorExtent(declaration));
    return range_of(c, clang_getRange(name, end), &is_from_macro);
}

static bool is_static(CXCursor declaration) {
    return clang_Cursor_getStorageClass(declaration) == CX_SC_Static;
}

/* Is the variable declared in a function, and not merely named there by a declaration such as
 * `extern int x;`? */
static bool is_of_function(CXCursor declaration) {
    CXCursor parent = clang_getCursorSemanticParent(declaration);
    return clang_getCursorKind(parent) == CXCursor_FunctionDecl &&
           clang_getCursorLinkage(declaration) == CXLinkage_NoLinkage;
}

static ir_storage storage_of(CXCursor declaration) {
    if (clang_getCursorKind(declaration) == CXCursor_ParmDecl)
        return IR_PARAMETER;
    if (clang_getCursorTLSKind(declaration) != CXTLS_None)
        return IR_THREAD_LOCAL;
    if (is_of_function(declaration))
        return is_static(declaration) ? IR_STATIC_LOCAL : IR_LOCAL;
    return clang_getCursorLinkage(declaration) == CXLinkage_Internal ? IR_STATIC : IR_GLOBAL;
}

/* Returns the type in the variable's definition, if there is one. That type has an array's length,
 * which other declarations may omit. */
static CXType type_of_variable(CXCursor declaration) {
    CXCursor definition = clang_getCursorDefinition(declaration);
    return clang_getCursorType(clang_Cursor_isNull(definition) ? declaration : definition);
}

ir_variable *convert_variable(converter *c, CXCursor declaration) {
    const void *own = declaration.data[0];
    ir_variable *v = map_get(c->converted.variables, &own, sizeof own);
    if (v != NULL)
        return v;
    CXCursor first = clang_getCanonicalCursor(declaration);
    const void *key = first.data[0];
    v = map_get(c->converted.variables, &key, sizeof key);
    if (v != NULL) {
        *map_at(c->converted.variables, &own, sizeof own) = v;
        return v;
    }
    v = ARENA_NEW(c->arena, ir_variable);
    *map_at(c->converted.variables, &key, sizeof key) = v;
    *map_at(c->converted.variables, &own, sizeof own) = v;
    v->name = take_string(c, clang_getCursorSpelling(first));
    v->type = convert_type(c, type_of_variable(declaration));
    v->storage = storage_of(first);
    v->has_other_name = has_other_name(c, first) || has_other_name(c, declaration);
    bool is_parameter = v->storage == IR_PARAMETER;
    if (is_parameter)
        v->type = decayed(c, v->type);
    v->function = is_parameter || is_of_function(first) ? c->function : NULL;
    v->range = range_from_name(c, first);
    v->declared = declared_of(c, first);
    VECTOR_PUSH(c->arena, &c->found, v);
    return v;
}

/* ---- functions ----------------------------------------------------------------------------- */

static void convert_parameters(converter *c, ir_function *f, CXCursor declaration) {
    int count = clang_Cursor_getNumArguments(declaration);
    if (count <= 0)
        return;
    ir_function *outer = c->function;
    ir_variable **parameters = ARENA_ARRAY(c->arena, ir_variable *, count);
    c->function = f;
    for (int i = 0; i < count; i++)
        parameters[i] = convert_variable(c, clang_Cursor_getArgument(declaration, (unsigned)i));
    c->function = outer;
    f->parameters = parameters;
    f->parameter_count = (unsigned)count;
}

/* Fills in the function's properties. `declaration` must be the definition if there is one, because
 * the body uses its parameters. */
static void fill_function(converter *c, ir_function *f, CXCursor declaration) {
    bool is_from_macro;
    f->name = take_string(c, clang_getCursorSpelling(declaration));
    f->type = convert_type(c, clang_getCursorType(declaration));
    f->range = range_of(c, clang_getCursorExtent(declaration), &is_from_macro);
    f->linkage.is_static = is_static(declaration);
    f->is_variadic = clang_Cursor_isVariadic(declaration) != 0;
    f->is_in_main_file = is_in_main_file(c, clang_getCursorLocation(declaration));
    read_attributes(c, clang_getCanonicalCursor(declaration), f);
    read_attributes(c, declaration, f);
    convert_parameters(c, f, declaration);
}

ir_function *convert_function(converter *c, CXCursor declaration) {
    const void *own = declaration.data[0];
    ir_function *f = map_get(c->converted.functions, &own, sizeof own);
    if (f != NULL)
        return f;
    const void *key = clang_getCanonicalCursor(declaration).data[0];
    f = map_get(c->converted.functions, &key, sizeof key);
    if (f != NULL) {
        read_attributes(c, declaration, f); /* a later declaration may add attributes */
        *map_at(c->converted.functions, &own, sizeof own) = f;
        return f;
    }
    f = ARENA_NEW(c->arena, ir_function);
    *map_at(c->converted.functions, &key, sizeof key) = f;
    *map_at(c->converted.functions, &own, sizeof own) = f;
    f->declared = declared_of(c, declaration);
    CXCursor definition = clang_getCursorDefinition(declaration);
    bool has_body = !clang_Cursor_isNull(definition);
    fill_function(c, f, has_body ? definition : declaration);
    read_attributes(c, declaration, f);
    f->has_errors = map_get(c->converted.functions_with_errors, &key, sizeof key) != NULL;
    if (has_body) {
        function_body body = {.function = f, .definition = definition};
        VECTOR_PUSH(c->arena, &c->pending, body);
    }
    if (has_body && f->is_in_main_file)
        VECTOR_PUSH(c->arena, &c->mains, f);
    else
        VECTOR_PUSH(c->arena, &c->others, f);
    return f;
}
