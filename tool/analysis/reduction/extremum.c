/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/reduction/extremum.h"

#include <string.h>

#include "analysis/base/expression.h"

static bool is_same_integer(const ir_type *a, const ir_type *b) {
    return a && b && a->kind == IR_INTEGER && b->kind == IR_INTEGER && a->size == b->size &&
           a->is_signed == b->is_signed;
}

/* The value with which the condition compares the target; NULL if it does not compare the
 * target. */
static const ir_node *compared_with(const ir_node *condition, const ir_node *target,
                                    bool *target_is_less) {
    if (condition->kind != IR_BINARY || condition->op < IR_OP_LESS ||
        condition->op > IR_OP_GREATER_EQUAL)
        return NULL;
    const ir_node *left = condition->children[0];
    const ir_node *right = condition->children[1];
    bool says_less = condition->op == IR_OP_LESS || condition->op == IR_OP_LESS_EQUAL;
    bool is_left = expression_same(left, target);
    if (!is_left && !expression_same(right, target))
        return NULL;
    *target_is_less = says_less == is_left;
    return is_left ? right : left;
}

/* Classifies an update that sets the target to `stored` if the condition is true, and to `kept`
 * otherwise. */
static extremum selection(const ir_node *condition, const ir_node *target, const ir_node *stored,
                          const ir_node *kept) {
    bool target_is_less;
    const ir_node *other = compared_with(condition, target, &target_is_less);
    if (!other)
        return (extremum){0};
    extremum found = {.target = target};
    bool takes_other = expression_same(stored, other) && expression_same(kept, target);
    bool keeps_other = expression_same(stored, target) && expression_same(kept, other);
    found.has_operator = takes_other || keeps_other;
    found.op = target_is_less == takes_other ? REDUCTION_MAXIMUM : REDUCTION_MINIMUM;
    found.commutes = found.has_operator && expression_is_plain(other) &&
                     !expression_occurrences(other, target) &&
                     is_same_integer(target->type, other->type);
    return found;
}

static const ir_node *only_statement(const ir_node *node) {
    while (node->kind == IR_BLOCK && node->child_count == 1)
        node = node->children[0];
    return node->kind == IR_EXPRESSION ? node->children[0] : node;
}

static extremum of_call(const ir_node *target, const ir_node *call) {
    if (call->child_count != 3 || call->children[0]->kind != IR_FUNCTION)
        return (extremum){0};
    const char *name = call->children[0]->function->name;
    bool is_maximum = strstr(name, "fmax") != NULL;
    if ((!is_maximum && !strstr(name, "fmin")) || (!expression_same(call->children[1], target) &&
                                                   !expression_same(call->children[2], target)))
        return (extremum){0};
    return (extremum){.target = target,
                      .has_operator = true,
                      .op = is_maximum ? REDUCTION_MAXIMUM : REDUCTION_MINIMUM};
}

extremum extremum_of(const ir_node *node) {
    if (node->kind == IR_IF && node->child_count == 2) {
        const ir_node *store = only_statement(node->children[1]);
        if (store->kind == IR_ASSIGN && store->op == IR_OP_NONE)
            return selection(node->children[0], store->children[0], store->children[1],
                             store->children[0]);
    }
    if (node->kind == IR_ASSIGN && node->op == IR_OP_NONE) {
        const ir_node *value = node->children[1];
        if (value->kind == IR_CONDITIONAL)
            return selection(value->children[0], node->children[0], value->children[1],
                             value->children[2]);
        if (value->kind == IR_CALL)
            return of_call(node->children[0], value);
    }
    return (extremum){0};
}
