/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/reduction/saturation.h"

#include <assert.h>

#include "analysis/base/expression.h"
#include "analysis/base/update_form.h"

static bool is_one(const ir_node *node) {
    int64_t value;
    return node->type && node->type->kind == IR_INTEGER && expression_constant(node, &value) &&
           value == 1;
}

/* Is it R++, ++R, R += 1, R = R + 1 or R = 1 + R? */
static bool is_step_up(const ir_node *node, const ir_node *target) {
    const update_form form = update_form_of(node);
    if (!form.is_update || !form.has_operator || form.op != REDUCTION_SUM ||
        !expression_same(form.target, target))
        return false;
    if (node->kind != IR_ASSIGN)
        return node->op == IR_OP_PRE_INCREMENT || node->op == IR_OP_POST_INCREMENT;
    if (node->op != IR_OP_NONE)
        return node->op == IR_OP_ADD && is_one(form.value);
    return form.value->op == IR_OP_ADD &&
           ((form.value->children[0] == form.self && is_one(form.value->children[1])) ||
            (form.value->children[1] == form.self && is_one(form.value->children[0])));
}

/* The type's greatest value; INT64_MAX if that is greater, since constants are held as int64_t. */
static int64_t highest_of(const ir_type *type) {
    assert(type->kind == IR_INTEGER && type->size > 0);
    const int64_t bits = 8 * type->size - type->is_signed;
    return bits < 63 ? ((int64_t)1 << bits) - 1 : INT64_MAX;
}

/* Is the constant greater than 0, and does the comparison convert neither operand to another
 * value? */
static bool compares_numbers(const ir_type *counter, const ir_node *constant, int64_t *value) {
    return constant->type && constant->type->kind == IR_INTEGER &&
           (constant->type->is_signed || !counter->is_signed) &&
           expression_constant(constant, value) && *value > 0;
}

/* Is the condition R < C, R <= C - 1, or R != C where C is the type's greatest value? The operands
 * may be swapped. Sets *limit to C. */
static bool is_below(const ir_node *condition, const ir_node *target, int64_t *limit) {
    assert(target->type->kind == IR_INTEGER);
    const bool reads_left =
        condition->child_count == 2 && expression_same(condition->children[0], target);
    const ir_type *type = target->type;
    const int64_t highest = highest_of(type);
    if (condition->kind != IR_BINARY ||
        (!reads_left && !expression_same(condition->children[1], target)) ||
        !compares_numbers(type, condition->children[reads_left], limit))
        return false;
    switch (condition->op) {
    case IR_OP_LESS:
        return reads_left && *limit <= highest;
    case IR_OP_GREATER:
        return !reads_left && *limit <= highest;
    case IR_OP_LESS_EQUAL:
        return reads_left && *limit < highest && (*limit)++ > 0;
    case IR_OP_GREATER_EQUAL:
        return !reads_left && *limit < highest && (*limit)++ > 0;
    case IR_OP_NOT_EQUAL:
        return type->size < 8 && *limit == highest;
    default:
        return false;
    }
}

bool saturation_of(const ir_node *statement, const ir_node *target, int64_t *limit) {
    if (statement->kind != IR_IF || statement->child_count != 2 ||
        !ir_type_is_plain_integer(target->type) || !expression_is_plain(target))
        return false;
    const ir_node *step = statement->children[1];
    while (step->kind == IR_BLOCK && step->child_count == 1)
        step = step->children[0];
    return step->kind == IR_EXPRESSION && is_step_up(step->children[0], target) &&
           is_below(statement->children[0], target, limit);
}
