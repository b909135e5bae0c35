/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/exact.h"

#include <assert.h>

#include "analysis/base/expression.h"

enum {
    SMALLEST_SIZE = 4, /* in bytes; a conversion to a smaller type is assumed to wrap around
                        * intentionally */
    ADDRESS_SIZE = 8   /* in bytes; arithmetic in this size wraps around as addresses do */
};

bool exact_is_operation(const ir_node *node) {
    if (!node->type || node->type->kind != IR_INTEGER)
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!node->children[i]->type || node->children[i]->type->kind != IR_INTEGER)
            return false;
    switch (node->kind) {
    case IR_BINARY:
        return node->op == IR_OP_ADD || node->op == IR_OP_SUBTRACT || node->op == IR_OP_MULTIPLY;
    case IR_UNARY:
        return node->op == IR_OP_PLUS || node->op == IR_OP_MINUS;
    case IR_CAST:
        return node->type->size >= SMALLEST_SIZE;
    default:
        return false;
    }
}

bool exact_needs_settled(const ir_node *node, const ir_node *operand) {
    assert(node->type && operand->type);
    return operand->type->size < node->type->size;
}

/* Does the conversion preserve every value of the operand's type, as a number or as an address? */
static bool keeps_value(const ir_type *from, const ir_type *to) {
    if (to->size >= ADDRESS_SIZE)
        return true;
    return from->size < to->size ? to->is_signed || !from->is_signed
                                 : from->size == to->size && from->is_signed == to->is_signed;
}

bool exact_is_settled(const ir_node *node, const ir_variable *counter) {
    if (!expression_mentions(node, counter) || node->kind == IR_VARIABLE ||
        node->type->size >= ADDRESS_SIZE)
        return true;
    if (node->kind == IR_CAST && !keeps_value(node->children[0]->type, node->type))
        return false;
    if (node->kind != IR_CAST && !ir_type_never_wraps(node->type))
        return false;
    /* if overflow is undefined, an operation that is executed does not overflow */
    for (unsigned i = 0; i < node->child_count; i++)
        if (!exact_needs_settled(node, node->children[i]) &&
            !exact_is_settled(node->children[i], counter))
            return false;
    return true;
}

static bool has_check(const ir_node *node, const ir_variable *counter) {
    for (unsigned i = 0; i < node->child_count; i++) {
        const ir_node *child = node->children[i];
        if (!expression_mentions(child, counter))
            continue;
        if (exact_needs_settled(node, child) && !exact_is_settled(child, counter))
            return true;
        if (has_check(child, counter))
            return true;
    }
    return false;
}

bool exact_may_wrap(const ir_node *subscript, const ir_variable *counter) {
    return !exact_is_settled(subscript, counter) || has_check(subscript, counter);
}

bool exact_may_fall_below(const ir_node *subscript, const ir_variable *counter) {
    if (!expression_mentions(subscript, counter))
        return false;
    if ((subscript->kind == IR_BINARY && subscript->op == IR_OP_SUBTRACT) ||
        (subscript->kind == IR_UNARY && subscript->op == IR_OP_MINUS))
        return true;
    for (unsigned i = 0; i < subscript->child_count; i++)
        if (exact_may_fall_below(subscript->children[i], counter))
            return true;
    return false;
}
