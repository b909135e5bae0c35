/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Variables and functions. Each is known by its canonical declaration. */
#include <string.h>

#include "frontend/translation.h"

static CXCursor definition_or(CXCursor declaration) {
    const CXCursor definition = clang_getCursorDefinition(declaration);
    return clang_Cursor_isNull(definition) ? declaration : definition;
}

static ir_storage storage_of(CXCursor declaration, bool in_function) {
    if (clang_getCursorTLSKind(declaration) != CXTLS_None)
        return IR_THREAD_LOCAL;
    if (clang_getCursorKind(declaration) == CXCursor_ParmDecl)
        return IR_PARAMETER;
    const enum CX_StorageClass class = clang_Cursor_getStorageClass(declaration);
    if (!in_function)
        return class == CX_SC_Static ? IR_STATIC : IR_GLOBAL;
    return class == CX_SC_Static ? IR_STATIC_LOCAL : class == CX_SC_Extern ? IR_GLOBAL : IR_LOCAL;
}

ir_variable *translate_variable(translation *t, CXCursor reference) {
    const CXCursor declaration = clang_getCanonicalCursor(reference);
    const void *key = declaration.data[0];
    ir_variable *variable = map_get(t->variables, &key, sizeof key);
    if (variable)
        return variable;
    variable = ARENA_NEW(t->arena, ir_variable);
    *map_at(t->variables, &key, sizeof key) = variable;
    const CXCursor definition = definition_or(declaration);
    const enum CXCursorKind parent =
        clang_getCursorKind(clang_getCursorSemanticParent(declaration));
    const bool in_function = parent == CXCursor_FunctionDecl;
    variable->name = take_string(t, clang_getCursorSpelling(declaration));
    variable->type = translate_type(t, clang_getCursorType(definition));
    variable->storage = storage_of(declaration, in_function);
    variable->function = in_function || variable->storage == IR_PARAMETER ? t->current : NULL;
    variable->range = place_range(t, declaration);
    variable->id = t->variable_list.count;
    VECTOR_PUSH(t->arena, &t->variable_list, variable);
    return variable;
}

static void read_attributes(translation *t, ir_function *function, CXCursor declaration) {
    const cursor_list children = children_of(t, declaration);
    for (unsigned i = 0; i < children.count; i++) {
        const enum CXCursorKind kind = clang_getCursorKind(children.items[i]);
        function->is_attribute_pure |= kind == CXCursor_PureAttr;
        function->is_attribute_const |= kind == CXCursor_ConstAttr;
    }
}

ir_function *translate_function(translation *t, CXCursor reference) {
    const CXCursor canonical = clang_getCanonicalCursor(reference);
    const void *key = canonical.data[0];
    ir_function *function = map_get(t->functions, &key, sizeof key);
    if (function)
        return function;
    function = ARENA_NEW(t->arena, ir_function);
    *map_at(t->functions, &key, sizeof key) = function;
    const CXCursor declaration = definition_or(canonical);
    const CXType type = clang_getCursorType(declaration);
    function->name = take_string(t, clang_getCursorSpelling(declaration));
    function->type = translate_type(t, type);
    function->range = place_range(t, declaration);
    function->is_static = clang_Cursor_getStorageClass(canonical) == CX_SC_Static;
    function->is_variadic = clang_isFunctionTypeVariadic(type) != 0;
    const char *spelling = take_string(t, clang_getTypeSpelling(type));
    function->is_noreturn = strstr(spelling, "noreturn") != NULL;
    function->is_in_main_file = place_is_in_main_file(t, declaration);
    read_attributes(t, function, canonical);
    read_attributes(t, function, declaration);
    function->id = t->function_list.count;
    VECTOR_PUSH(t->arena, &t->function_list, function);
    if (clang_isCursorDefinition(declaration))
        VECTOR_PUSH(t->arena, &t->pending, ((pending_body){function, declaration}));
    return function;
}

/* The top of the access path that a variable's node begins, as far as it stays inside the object.
 */
static const ir_node *object_path(const ir_node *node) {
    for (;;) {
        const ir_node *parent = node->parent;
        const bool inside = parent && ((parent->kind == IR_MEMBER && !(parent->flags & IR_ARROW)) ||
                                       (parent->kind == IR_INDEX && parent->children[0] == node &&
                                        node->type && node->type->kind == IR_ARRAY));
        if (!inside)
            return node;
        node = parent;
    }
}

static bool note_address(ir_node *node, void *context) {
    (void)context;
    if (node->kind != IR_VARIABLE || !node->variable)
        return true;
    const ir_node *path = object_path(node), *parent = path->parent;
    if (!parent)
        return true;
    if (parent->kind == IR_UNARY && parent->op == IR_OP_ADDRESS)
        node->variable->address_taken = true;
    if (path->type && path->type->kind == IR_ARRAY && parent->kind != IR_CALL &&
        parent->kind != IR_SIZEOF && parent->kind != IR_INDEX)
        node->variable->address_taken = true;
    return true;
}

static void translate_body(translation *t, ir_function *function, CXCursor definition) {
    VECTOR(ir_variable *) parameters = {0};
    const cursor_list children = children_of(t, definition);
    t->current = function;
    t->depth = 0;
    t->too_deep = false;
    for (unsigned i = 0; i < children.count; i++) {
        const enum CXCursorKind kind = clang_getCursorKind(children.items[i]);
        if (kind == CXCursor_ParmDecl)
            VECTOR_PUSH(t->arena, &parameters, translate_variable(t, children.items[i]));
        else if (kind == CXCursor_CompoundStmt)
            function->body = translate_statement(t, children.items[i]);
    }
    function->parameter_count = parameters.count;
    function->parameters = parameters.items;
    function->has_errors |= t->too_deep;
    if (function->body) {
        ir_finish_function(function);
        ir_walk(function->body, note_address, NULL);
    }
    t->current = NULL;
}

void translate_pending(translation *t) {
    for (unsigned i = 0; i < t->pending.count; i++) {
        const pending_body next = t->pending.items[i];
        translate_body(t, next.function, next.definition);
    }
    t->pending.count = 0;
}
