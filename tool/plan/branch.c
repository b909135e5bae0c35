/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/branch.h"

#include <assert.h>

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "ir/ir_syntax.h"
#include "plan/fresh.h"
#include "plan/lookup.h"

/* ---- variables ------------------------------------------------------------------------------- */

static bool is_mentioned_outside(const ir_node *tree, const ir_node *part,
                                 const ir_variable *variable) {
    if (tree == part)
        return false;
    if ((tree->kind == IR_VARIABLE || tree->kind == IR_DECLARATOR) && tree->variable == variable)
        return true;
    for (unsigned i = 0; i < tree->child_count; i++)
        if (is_mentioned_outside(tree->children[i], part, variable))
            return true;
    return false;
}

/** May the node be a jump into a branch, or the target of one? */
static bool may_be_entered(const ir_node *node) {
    return node->kind == IR_LABEL || node->kind == IR_GOTO || node->kind == IR_SWITCH ||
           node->kind == IR_OPAQUE;
}

bool is_only_of_branch(const loop_facts *facts, const ir_node *branch,
                       const ir_variable *variable) {
    assert(ir_contains(facts->loop, branch));
    const ir_node *const body = facts->counted.body;
    const ir_node *const declarator = ir_declarator_in(branch, variable);
    const bool has_start = declarator && declarator->child_count > 0;
    return (variable->storage == IR_LOCAL || variable->storage == IR_PARAMETER) &&
           variable != facts->counted.counter && !variable->address_taken &&
           !variable->has_other_name && ir_type_is_scalar(variable->type) &&
           !ir_any(body, may_be_entered) && !is_mentioned_outside(facts->loop, branch, variable) &&
           (has_start || is_fresh_in(branch, variable));
}

/* ---- loops ----------------------------------------------------------------------------------- */

/** Does the expression consist of constants, and of variables and their members that the outer loop
 *  only reads? */
static bool is_steady(const loop_facts *facts, const ir_node *node) {
    switch (node->kind) {
    case IR_NUMBER:
        return node->flags & IR_HAS_VALUE;
    case IR_VARIABLE:
        return (node->variable->storage == IR_LOCAL || node->variable->storage == IR_PARAMETER) &&
               !node->variable->address_taken && is_captured(facts, node->variable);
    case IR_MEMBER:
        return !(node->flags & IR_ARROW) && is_steady(facts, node->children[0]);
    case IR_CAST:
        return is_steady(facts, node->children[0]);
    case IR_BINARY:
        return (node->op == IR_OP_ADD || node->op == IR_OP_SUBTRACT ||
                node->op == IR_OP_MULTIPLY) &&
               is_steady(facts, node->children[0]) && is_steady(facts, node->children[1]);
    default:
        return false;
    }
}

/** Can the counter have every value that the bound may have? If not, the bound could be beyond all
 * values of the counter, or C would compare a negative counter as a large number. */
static bool has_values_of(const ir_type *counter, const ir_type *bound) {
    return ir_type_is_plain_integer(bound) &&
           (bound->size < counter->size ||
            (bound->size == counter->size && (bound->is_signed || !counter->is_signed)));
}

/** Is the bound a constant so near to 0 that the step across it cannot overflow the counter? */
static bool is_near(const ir_node *bound, int64_t step, const ir_type *counter) {
    enum { FAR = (1 << 30) - 1 };
    return bound->flags & IR_HAS_VALUE && bound->value <= FAR && step >= -FAR && step <= FAR &&
           bound->value >= (counter->is_signed ? -FAR : 0);
}

/** Does `counter <op> bound` become false before a step overflows? */
static bool is_reached(ir_operator op, const ir_node *bound, int64_t step, const ir_type *counter) {
    if (!has_values_of(counter, bound->type))
        return false;
    const bool near = is_near(bound, step, counter);
    switch (op) {
    case IR_OP_LESS:
        return step == 1 || (step > 0 && near);
    case IR_OP_LESS_EQUAL:
        return step > 0 && near;
    case IR_OP_GREATER:
        return counter->is_signed && (step == -1 || (step < 0 && near));
    case IR_OP_GREATER_EQUAL:
        return counter->is_signed && step < 0 && near;
    default:
        return false;
    }
}

bool ends_in_any_case(const loop_facts *facts, const ir_node *loop) {
    assert(ir_is_loop(loop));
    ir_variable *counter;
    int64_t step;
    if (loop->kind != IR_FOR || !counted_step(loop->children[2], &counter, &step))
        return false;
    const ir_node *condition = loop->children[1];
    return condition->kind == IR_BINARY &&
           expression_is_variable(condition->children[0], counter) &&
           ir_type_is_plain_integer(counter->type) && counter->type->size >= 4 &&
           counter->storage == IR_LOCAL && !counter->address_taken && !counter->has_other_name &&
           is_steady(facts, condition->children[1]) &&
           is_reached(condition->op, condition->children[1], step, counter->type) &&
           !variable_is_written_in(ir_loop_body(loop), counter);
}
