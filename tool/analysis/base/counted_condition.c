/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The condition compares the counter after the step (--i >= 0) or before it (i-- > 0). Either way,
 * the counter in the first iteration is the first value plus one step. For integers, `i-- > n` is
 * true exactly if i >= n after the step. In a do loop this holds from the second iteration on; in
 * the first iteration the counter has the first value. */
#include "analysis/base/counted_condition.h"

#include <assert.h>

#include "analysis/base/expression.h"

/* The implicit comparison of a bare `n--` with the int 0. */
static const ir_type number_type = {
    .kind = IR_INTEGER, .is_signed = true, .size = 4, .spelling = "int"};
static const ir_node zero = {
    .kind = IR_NUMBER, .flags = IR_HAS_VALUE, .type = &number_type, .text = "0"};

static bool is_step(const ir_node *node) {
    return ir_is_increment(node) && node->children[0]->kind == IR_VARIABLE;
}

static bool is_before_test(const ir_node *step) {
    return step->op == IR_OP_PRE_INCREMENT || step->op == IR_OP_PRE_DECREMENT;
}

/* Returns the comparison of the stepped counter that is equivalent to `comparison` of the counter
 * before the step. IR_OP_NONE if there is none, or if the step leads away from the bound. */
static ir_operator after_step(ir_operator comparison, int64_t step) {
    assert(step == 1 || step == -1);
    if (comparison == IR_OP_NOT_EQUAL)
        return step < 0 ? IR_OP_GREATER_EQUAL : IR_OP_LESS_EQUAL;
    if (comparison == IR_OP_GREATER && step < 0)
        return IR_OP_GREATER_EQUAL;
    return comparison == IR_OP_LESS && step > 0 ? IR_OP_LESS_EQUAL : IR_OP_NONE;
}

void counted_split_bare(counted_loop *counted) {
    assert(counted->counter && counted->step != 0);
    counted->comparison = IR_OP_NOT_EQUAL;
    counted->bound = &zero;
}

bool counted_is_bare(const counted_loop *counted) {
    return counted->bound == &zero;
}

bool counted_split_stepping(const ir_node *condition, counted_loop *counted) {
    const ir_node *step = condition;
    counted->comparison = IR_OP_NOT_EQUAL;
    counted->bound = &zero;
    if (condition->kind == IR_BINARY && condition->op >= IR_OP_LESS &&
        condition->op <= IR_OP_NOT_EQUAL && condition->op != IR_OP_EQUAL) {
        const unsigned side = is_step(condition->children[0]) ? 0 : 1;
        step = condition->children[side];
        counted->bound = condition->children[1 - side];
        counted->comparison = side ? expression_mirrored(condition->op) : condition->op;
    }
    if (!is_step(step) || expression_mentions(counted->bound, step->children[0]->variable))
        return false;
    counted->counter = step->children[0]->variable;
    counted->increment = step;
    counted->step = step->op == IR_OP_PRE_INCREMENT || step->op == IR_OP_POST_INCREMENT ? 1 : -1;
    counted->steps_first = true;
    counted->ends_below = !is_before_test(step);
    if (counted->ends_below)
        counted->comparison = after_step(counted->comparison, counted->step);
    return counted->comparison != IR_OP_NONE;
}

bool counted_stepping_wraps(const counted_loop *counted) {
    assert(counted->counter && counted->bound);
    assert(counted->step == 1 || counted->step == -1);
    const ir_type *counter = counted->counter->type;
    const ir_type *bound = counted->bound->type;
    int64_t constant;
    if (counter->size < 4 || counter->wraps)
        return true;
    if (counter->is_signed) /* converted to an unsigned type, negative values of the counter would
                             * become large */
        return !bound->is_signed && bound->size >= 4;
    return counted->step > 0 || !counted->ends_below ||
           !expression_constant(counted->bound, &constant) || constant != 0;
}
