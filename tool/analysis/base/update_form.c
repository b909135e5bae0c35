/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/update_form.h"

#include "analysis/base/expression.h"

static bool operator_of(ir_operator op, reduction_operator *reduction) {
    switch (op) {
    case IR_OP_ADD:
    case IR_OP_SUBTRACT:
        *reduction = REDUCTION_SUM;
        return true;
    case IR_OP_MULTIPLY:
        *reduction = REDUCTION_PRODUCT;
        return true;
    case IR_OP_BIT_AND:
        *reduction = REDUCTION_AND;
        return true;
    case IR_OP_BIT_OR:
        *reduction = REDUCTION_OR;
        return true;
    case IR_OP_BIT_XOR:
        *reduction = REDUCTION_XOR;
        return true;
    default:
        return false;
    }
}

/* Finds the target in the value by descending through operators of one kind (+ and - count as one),
 * but never into the subtracted side of a `-`. NULL if the target is not found. */
static const ir_node *find_self(const ir_node *value, const ir_node *target,
                                reduction_operator op) {
    reduction_operator here;
    if (expression_same(value, target))
        return value;
    if (value->kind != IR_BINARY || !operator_of(value->op, &here) || here != op)
        return NULL;
    const ir_node *self = find_self(value->children[0], target, op);
    if (!self && value->op != IR_OP_SUBTRACT)
        self = find_self(value->children[1], target, op);
    return self;
}

static update_form assignment_form(const ir_node *node) {
    update_form form = {.target = node->children[0], .value = node->children[1]};
    if (node->op != IR_OP_NONE) {
        form.is_update = true;
        form.has_operator = operator_of(node->op, &form.op);
        return form;
    }
    unsigned count = expression_occurrences(form.value, form.target);
    if (count == 0 || form.target->kind == IR_VARIABLE || !expression_is_plain(form.target))
        return form;
    form.is_update = true;
    if (count == 1 && form.value->kind == IR_BINARY && operator_of(form.value->op, &form.op)) {
        form.self = find_self(form.value, form.target, form.op);
        form.has_operator = form.self != NULL;
    }
    return form;
}

update_form update_form_of(const ir_node *node) {
    if (node->kind == IR_ASSIGN)
        return assignment_form(node);
    update_form form = {0};
    if (ir_is_increment(node)) {
        form.is_update = form.has_operator = true;
        form.op = REDUCTION_SUM;
        form.target = node->children[0];
    }
    return form;
}
