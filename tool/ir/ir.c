/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ir/ir.h"

#include <assert.h>
#include <string.h>

bool ir_is_expression(const ir_node *node) {
    if (node->kind == IR_OPAQUE)
        return node->type != NULL;
    return node->kind < IR_OPAQUE;
}

bool ir_is_access(const ir_node *node) {
    return node->kind == IR_INDEX || node->kind == IR_MEMBER ||
           (node->kind == IR_UNARY && node->op == IR_OP_DEREFERENCE);
}

bool ir_reads_memory(const ir_node *node) {
    return ir_is_access(node) && node->type && !ir_is_array(node);
}

bool ir_is_address_of(const ir_node *node) {
    return node->kind == IR_UNARY && node->op == IR_OP_ADDRESS;
}

ir_function *ir_called_function(const ir_node *call) {
    assert(call->kind == IR_CALL);
    return call->children[0]->kind == IR_FUNCTION ? call->children[0]->function : NULL;
}

bool ir_is_array(const ir_node *node) {
    return node->type && node->type->kind == IR_ARRAY;
}

bool ir_is_pointer(const ir_node *node) {
    return node->type && node->type->kind == IR_POINTER;
}

bool ir_is_loop(const ir_node *node) {
    return node->kind == IR_FOR || node->kind == IR_WHILE || node->kind == IR_DO;
}

const ir_node *ir_loop_body(const ir_node *loop) {
    assert(ir_is_loop(loop));
    return loop->children[loop->kind == IR_FOR ? 3 : loop->kind == IR_WHILE ? 1 : 0];
}

bool ir_any(const ir_node *node, ir_question question) {
    if (question(node))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (ir_any(node->children[i], question))
            return true;
    return false;
}

bool ir_has_kind(const ir_node *node, ir_kind kind) {
    if (node->kind == kind)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (ir_has_kind(node->children[i], kind))
            return true;
    return false;
}

bool ir_may_be_entered(const ir_node *node) {
    return ir_has_kind(node, IR_LABEL) || ir_has_kind(node, IR_CASE) ||
           ir_has_kind(node, IR_DEFAULT);
}

bool ir_holds_case(const ir_node *node) {
    if (node->kind == IR_CASE || node->kind == IR_DEFAULT)
        return true;
    for (unsigned i = 0; node->kind != IR_SWITCH && i < node->child_count; i++)
        if (ir_holds_case(node->children[i]))
            return true;
    return false;
}

bool ir_is_increment(const ir_node *node) {
    return node->kind == IR_UNARY && node->op >= IR_OP_PRE_INCREMENT &&
           node->op <= IR_OP_POST_DECREMENT;
}

bool ir_is_complex_part(const ir_node *node) {
    return node->kind == IR_UNARY && (node->op == IR_OP_REAL || node->op == IR_OP_IMAG);
}

bool ir_continues(const ir_node *node) {
    if (node->kind == IR_CONTINUE)
        return !(node->flags & IR_LEAVES);
    for (unsigned i = 0; !ir_is_loop(node) && i < node->child_count; i++)
        if (ir_continues(node->children[i]))
            return true;
    return false;
}

bool ir_is_jump(const ir_node *node) {
    return node->kind == IR_BREAK || node->kind == IR_CONTINUE || node->kind == IR_GOTO ||
           node->kind == IR_RETURN;
}

static bool leaves_loop(const ir_node *node, bool by_break) {
    if (node->kind == IR_RETURN || node->kind == IR_GOTO || (node->kind == IR_BREAK && by_break))
        return true;
    const bool breaks_inside = by_break && !ir_is_loop(node) && node->kind != IR_SWITCH;
    for (unsigned i = 0; i < node->child_count; i++)
        if (leaves_loop(node->children[i], breaks_inside))
            return true;
    return false;
}

bool ir_leaves_loop(const ir_node *body) {
    return leaves_loop(body, true);
}

bool ir_is_statement_expression(const ir_node *node) {
    return node->kind == IR_OPAQUE && node->child_count == 1 && node->children[0]->kind == IR_BLOCK;
}

bool ir_is_lengths(const ir_node *node) {
    const ir_node *above = node->parent;
    return node->kind == IR_OPAQUE && above && above->kind == IR_DECLARATOR &&
           above->variable->type->kind == IR_ARRAY && above->variable->type->size < 0;
}

static bool is_effect(const ir_node *node) {
    return node->kind == IR_ASSIGN || node->kind == IR_CALL || node->kind == IR_OPAQUE ||
           ir_is_increment(node);
}

bool ir_has_effect(const ir_node *node) {
    return ir_any(node, is_effect);
}

/* Is the value of `child` used by `parent`, or by a node above it? */
static bool parent_uses_value(const ir_node *parent, const ir_node *child) {
    switch (parent->kind) {
    case IR_EXPRESSION:
        return false;
    case IR_FOR:
        return child != parent->children[0] && child != parent->children[2];
    case IR_CAST:
        return parent->type->kind != IR_VOID;
    case IR_CONDITIONAL: /* the value of the chosen operand is the value of the conditional */
        return child == parent->children[0] || ir_value_is_used(parent);
    case IR_BINARY:
        if (parent->op == IR_OP_COMMA)
            return child == parent->children[1] && ir_value_is_used(parent);
        if (parent->op == IR_OP_AND || parent->op == IR_OP_OR)
            return child == parent->children[0] || ir_value_is_used(parent);
        return true;
    default:
        return true;
    }
}

bool ir_value_is_used(const ir_node *node) {
    return node->parent == NULL || parent_uses_value(node->parent, node);
}

const ir_node *ir_declarator_in(const ir_node *tree, const ir_variable *variable) {
    assert(variable);
    if (tree->kind == IR_DECLARATOR && tree->variable == variable)
        return tree;
    for (unsigned i = 0; i < tree->child_count; i++) {
        const ir_node *found = ir_declarator_in(tree->children[i], variable);
        if (found)
            return found;
    }
    return NULL;
}

bool ir_contains(const ir_node *outer, const ir_node *inner) {
    while (inner != NULL && inner != outer)
        inner = inner->parent;
    return inner != NULL;
}

static bool is_path_step(const ir_node *node) {
    switch (node->kind) {
    case IR_INDEX:
    case IR_MEMBER:
    case IR_CAST:
        return true;
    case IR_UNARY:
        return node->op == IR_OP_DEREFERENCE || node->op == IR_OP_ADDRESS;
    default:
        return false;
    }
}

ir_variable *ir_root_variable(const ir_node *node) {
    while (is_path_step(node))
        node = node->children[0];
    return node->kind == IR_VARIABLE ? node->variable : NULL;
}

const ir_function *ir_function_named(const ir_unit *unit, const char *name) {
    for (unsigned i = 0; i < unit->function_count; i++)
        if (strcmp(unit->functions[i]->name, name) == 0)
            return unit->functions[i];
    return NULL;
}

void ir_walk(ir_node *node, ir_visitor visit, void *context) {
    if (!visit(node, context))
        return;
    for (unsigned i = 0; i < node->child_count; i++)
        ir_walk(node->children[i], visit, context);
}
