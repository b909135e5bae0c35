/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/memory/must_write/must_write_walk.h"

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "analysis/base/step_inside.h"

/* The value that the statement `v = value;` or the declaration `T v = value;` gives v, if the
 * statement writes v nowhere else. Otherwise NULL. */
static const ir_node *value_set_by(const ir_node *statement, const ir_variable *variable) {
    if (statement->kind == IR_DECLARATION) {
        const ir_node *declarator = ir_declarator_in(statement, variable);
        return declarator && !variable_is_written_in(statement, variable) ? ir_child(declarator, 0)
                                                                          : NULL;
    }
    const ir_node *assign = statement->kind == IR_EXPRESSION ? statement->children[0] : statement;
    return assign->kind == IR_ASSIGN && assign->op == IR_OP_NONE &&
                   expression_is_variable(assign->children[0], variable)
               ? assign->children[1]
               : NULL;
}

/* Returns NULL in a block of a switch, because a case label there may let control reach the loop
 * without executing the statement. */
const ir_node *start_before(const ir_node *loop, const ir_variable *variable, unsigned *number) {
    const ir_node *block = loop->parent;
    unsigned i = 0;
    if (!block || block->kind != IR_BLOCK || !block->parent || block->parent->kind == IR_SWITCH)
        return NULL;
    while (block->children[i] != loop)
        i++;
    while (i-- > 0) {
        *number = i;
        const ir_node *value = value_set_by(block->children[i], variable);
        if (value || variable_is_written_in(block->children[i], variable))
            return value;
    }
    return NULL;
}

static bool is_continue(const ir_node *node) {
    return node->kind == IR_CONTINUE;
}

/* The last statement of the body if it is a step v++, v += c or the like and nothing else in the
 * body writes v; otherwise NULL. */
static const ir_node *step_at_end(const ir_node *body, const ir_variable *variable) {
    if (body->kind != IR_BLOCK || !body->child_count)
        return NULL;
    const ir_node *last = body->children[body->child_count - 1];
    if (last->kind != IR_EXPRESSION)
        return NULL;
    const ir_node *step = last->children[0], *target = expression_written(step);
    int64_t constant;
    const bool is_step =
        ir_is_increment(step) ||
        (step->kind == IR_ASSIGN && (step->op == IR_OP_ADD || step->op == IR_OP_SUBTRACT) &&
         expression_constant(step->children[1], &constant));
    if (!is_step || !expression_is_variable(target, variable))
        return NULL;
    for (unsigned i = 0; i + 1 < body->child_count; i++)
        if (variable_is_written_in(body->children[i], variable))
            return NULL;
    return step;
}

const ir_node *step_of_body(const ir_node *body, const ir_variable *variable) {
    if (ir_any(body, is_continue))
        return NULL;
    const ir_node *step = lone_last_step(body, variable);
    return step ? step : step_at_end(body, variable);
}
