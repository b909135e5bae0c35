/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/overlap/row_address.h"

#include <assert.h>

static bool take_term(row_address *sum, const ir_node *subscript, int64_t bytes) {
    if (sum->term_count == ROW_MOST_TERMS || !subscript->type ||
        subscript->type->kind != IR_INTEGER || subscript->type->size > 8)
        return false;
    sum->terms[sum->term_count++] = (row_term){subscript, bytes};
    return true;
}

static bool take_pointer(row_address *sum, const ir_node *node);

static bool take_object(row_address *sum, const ir_node *node) {
    const ir_node *child = node->child_count ? node->children[0] : NULL;
    switch (node->kind) {
    case IR_VARIABLE:
        sum->base = node;
        sum->base_is_object = true;
        return true;
    case IR_INDEX:
        return node->type && node->type->size > 0 &&
               take_term(sum, node->children[1], node->type->size) && take_pointer(sum, child);
    case IR_MEMBER:
        if (!node->field || node->field->offset < 0)
            return false;
        sum->offset += node->field->offset;
        return node->flags & IR_ARROW ? take_pointer(sum, child) : take_object(sum, child);
    case IR_UNARY:
        return node->op == IR_OP_DEREFERENCE && take_pointer(sum, child);
    default:
        return false;
    }
}

/* Splits p + k, k + p or p - k. */
static bool take_moved(row_address *sum, const ir_node *node) {
    const ir_type *target = node->type->target;
    const bool is_second = !ir_is_pointer(node->children[0]) && !ir_is_array(node->children[0]);
    const bool is_down = node->op == IR_OP_SUBTRACT;
    if ((node->op != IR_OP_ADD && !is_down) || (is_second && is_down) || !target ||
        target->size <= 0)
        return false;
    return take_term(sum, node->children[is_second ? 0 : 1],
                     is_down ? -target->size : target->size) &&
           take_pointer(sum, node->children[is_second ? 1 : 0]);
}

static bool take_pointer(row_address *sum, const ir_node *node) {
    const ir_node *child = node->child_count ? node->children[0] : NULL;
    if (ir_is_array(node))
        return take_object(sum, node);
    if (!ir_is_pointer(node))
        return false;
    if (node->kind == IR_BINARY)
        return take_moved(sum, node);
    if (node->kind == IR_UNARY && node->op == IR_OP_ADDRESS)
        return take_object(sum, child);
    if (node->kind == IR_CAST && (ir_is_pointer(child) || ir_is_array(child)))
        return take_pointer(sum, child);
    sum->base = node;
    sum->base_is_object = false;
    return true;
}

bool row_address_of(const ir_node *row, row_address *address) {
    assert(ir_is_expression(row));
    *address = (row_address){0};
    return row->type && row->type->size > 0 && take_object(address, row);
}
