/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Tests whether the compiled part of a file may contain floating-point arithmetic. Under some
 * options its bits depend on the compiler's inlining, which depends on how often a function is
 * called. The copies in a translated loop add calls, so even the bits of another loop may
 * change. */
#include "frontend/convert.h"

static bool is_floating(const ir_type *type) {
    return type != NULL &&
           (type->kind == IR_FLOATING || type->kind == IR_COMPLEX || type->kind == IR_OTHER_TYPE);
}

/* Returns the type of the node's value. For a declarator, this is the variable's type, because the
 * declarator converts its initialiser without a separate node. */
static const ir_type *type_made(const ir_node *node) {
    return node->kind == IR_DECLARATOR ? node->variable->type : node->type;
}

static bool note_floating(ir_node *node, void *context) {
    bool *found = context;
    *found |= node->kind == IR_OPAQUE || is_floating(type_made(node));
    return !*found;
}

static bool function_is_floating(const ir_function *function) {
    bool found = is_floating(function->type->target);
    for (unsigned i = 0; i < function->parameter_count; i++)
        found |= is_floating(function->parameters[i]->type);
    ir_walk(function->body, note_floating, &found);
    return found;
}

bool has_floating_work(const ir_unit *unit) {
    for (unsigned i = 0; i < unit->function_count; i++) {
        const ir_function *function = unit->functions[i];
        const bool is_used = function->reference_count > 0 ||
                             !(function->linkage.is_static || function->is_from_system);
        if (function->body != NULL && is_used && function_is_floating(function))
            return true;
    }
    return false;
}
