/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/counted_stride.h"

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"

bool stride_is_unwritten(const ir_node *loop, const ir_node *node) {
    const ir_variable *variable = node->variable;
    if (node->kind == IR_VARIABLE)
        return ir_type_is_plain_integer(node->type) && variable_is_automatic(variable) &&
               !variable->has_other_name && !ir_declarator_in(loop, variable) &&
               !variable_is_written_in(loop, variable);
    if ((node->kind != IR_NUMBER && node->kind != IR_CAST && node->kind != IR_BINARY &&
         node->kind != IR_UNARY) ||
        !ir_type_is_plain_integer(node->type) || expression_is_hazard(node))
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!stride_is_unwritten(loop, node->children[i]))
            return false;
    return true;
}

static bool is_exposed(const ir_node *node) {
    return node->kind == IR_VARIABLE && node->variable->address_taken;
}

bool stride_is_steady(const ir_node *loop, const ir_node *node) {
    return stride_is_unwritten(loop, node) && !ir_any(node, is_exposed);
}

const ir_node *stride_added(const ir_node *write, const ir_variable *v, bool *is_down) {
    if (write->kind != IR_ASSIGN || !expression_is_variable(write->children[0], v))
        return NULL;
    const ir_node *value = write->children[1];
    ir_operator op = write->op;
    if (op == IR_OP_NONE && value->kind == IR_BINARY) {
        op = value->op;
        const unsigned side = expression_is_variable(value->children[0], v) ? 0 : 1;
        if (!expression_is_variable(value->children[side], v) || (side && op != IR_OP_ADD))
            return NULL;
        value = value->children[1 - side];
    }
    *is_down = op == IR_OP_SUBTRACT;
    return op == IR_OP_ADD || op == IR_OP_SUBTRACT ? value : NULL;
}

bool counted_split_stride(const ir_node *loop, const ir_node *increment, counted_loop *counted) {
    const ir_node *target = expression_written(increment);
    ir_variable *v = target && target->kind == IR_VARIABLE ? target->variable : NULL;
    bool is_down = false;
    const ir_node *stride =
        v && ir_type_is_plain_integer(v->type) ? stride_added(increment, v, &is_down) : NULL;
    if (!stride || !stride_is_steady(loop, stride))
        return false;
    counted->counter = v;
    counted->step = is_down ? -1 : 1;
    counted->stride = stride;
    return true;
}
