/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/loop/loop_analysis.h"

#include <assert.h>

#include "analysis/base/expression.h"
#include "analysis/base/reason.h"

bool analysis_refuse(loop_analysis *j, reason_id why, const ir_node *node, const char *name) {
    assert(why > REASON_NONE && why < REASON_COUNT);
    if (j->why.id != REASON_NONE)
        return false;
    ir_range range = node ? node->range : j->loop->range;
    if (range.begin >= range.end)
        range = j->loop->range;
    j->why = reason_make(j->an->memory, why, name ? name : "?", range);
    return false;
}

bool analysis_is_update(const loop_analysis *j, const ir_node *statement) {
    for (unsigned i = 0; i < j->updates.count; i++)
        if (j->updates.items[i].statement == statement)
            return true;
    return false;
}

const char *analysis_name(const loop_analysis *j, const ir_node *lvalue) {
    if (!lvalue)
        return "?";
    location where = location_of(j->an->facts, lvalue, j->loop);
    if (where.base)
        return expression_text(j->an->memory, where.base);
    const ir_variable *root = ir_root_variable(lvalue);
    return root ? root->name : expression_text(j->an->memory, lvalue);
}

/* What is made of a base on the way to its elements: b[i], *(b + i), (*b).x. */
static bool leads_on(const ir_node *parent, const ir_node *node) {
    const bool is_left = parent->child_count > 0 && parent->children[0] == node;
    const bool is_pointer = node->type->kind == IR_POINTER || node->type->kind == IR_ARRAY;
    if (parent->kind == IR_BINARY)
        return is_pointer && parent->type->kind == IR_POINTER;
    return is_left && (parent->kind == IR_INDEX || parent->kind == IR_MEMBER ||
                       (parent->kind == IR_UNARY && parent->op == IR_OP_DEREFERENCE));
}

bool has_address_as_value(const ir_node *node, const ir_node *base) {
    for (unsigned i = 0; i < node->child_count; i++)
        if (has_address_as_value(node->children[i], base))
            return true;
    if (!ir_is_expression(node) || !node->type || !expression_same(node, base))
        return false;
    while (node->parent && ir_is_expression(node->parent) && node->parent->type &&
           leads_on(node->parent, node))
        node = node->parent;
    const ir_node *user = node->parent;
    const bool is_taken = user->kind == IR_UNARY && user->op == IR_OP_ADDRESS;
    const bool is_address = node->type->kind == IR_POINTER || node->type->kind == IR_ARRAY;
    if (is_taken)
        user = user->parent;
    return (is_taken || is_address) && user->kind != IR_CALL;
}
