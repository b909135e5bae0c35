/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/step_inside.h"

#include "analysis/base/expression.h"

bool is_step_afterwards(const ir_node *node) {
    return node->kind == IR_UNARY &&
           (node->op == IR_OP_POST_INCREMENT || node->op == IR_OP_POST_DECREMENT) &&
           node->children[0]->kind == IR_VARIABLE;
}

static unsigned mentions(const ir_node *node, const ir_variable *variable) {
    unsigned count = node->kind == IR_VARIABLE && node->variable == variable;
    for (unsigned i = 0; i < node->child_count; i++)
        count += mentions(node->children[i], variable);
    return count;
}

/* Returns how often the variable is assigned or its address is taken. */
static unsigned writes(const ir_node *node, const ir_variable *variable) {
    const ir_node *target = expression_written(node);
    unsigned count = target && target->kind == IR_VARIABLE && target->variable == variable;
    count += node->kind == IR_UNARY && node->op == IR_OP_ADDRESS &&
             expression_object(node->children[0]) == variable;
    for (unsigned i = 0; i < node->child_count; i++)
        count += writes(node->children[i], variable);
    return count;
}

/* The last occurrence of the variable in the order of the text; NULL if there is none. */
static const ir_node *last_mention(const ir_node *node, const ir_variable *variable) {
    if (node->kind == IR_VARIABLE && node->variable == variable)
        return node;
    for (unsigned i = node->child_count; i-- > 0;) {
        const ir_node *found = last_mention(node->children[i], variable);
        if (found)
            return found;
    }
    return NULL;
}

const ir_node *lone_last_step(const ir_node *body, const ir_variable *variable) {
    const ir_node *last = last_mention(body, variable);
    const ir_node *step = last ? last->parent : NULL;
    if (!step || !is_step_afterwards(step) || !ir_value_is_used(step))
        return NULL;
    const ir_node *statement = expression_place(step);
    if (mentions(statement, variable) != 1 || writes(body, variable) != 1)
        return NULL;
    for (const ir_node *node = step; node != body; node = node->parent)
        if (!expression_evaluates(node->parent, node))
            return NULL;
    return step;
}

bool may_continue_before(const ir_node *body, const ir_node *step) {
    for (const ir_node *node = step; node != body; node = node->parent)
        for (unsigned i = 0; node->parent->kind == IR_BLOCK && node->parent->children[i] != node;
             i++)
            if (ir_continues(node->parent->children[i]))
                return true;
    return false;
}

/* Does the node contain steps v++ or v--? Sets *has_other if a variable that is stepped in it
 * occurs more than once in `statement`. */
static bool has_lone_steps(const ir_node *node, const ir_node *statement, bool *has_other) {
    bool has_step = is_step_afterwards(node);
    if (has_step)
        *has_other |= mentions(statement, node->children[0]->variable) != 1;
    for (unsigned i = 0; i < node->child_count; i++)
        has_step |= has_lone_steps(node->children[i], statement, has_other);
    return has_step;
}

static void leave_steps_out(ir_node *node) {
    for (unsigned i = 0; i < node->child_count; i++) {
        ir_node *child = node->children[i];
        if (is_step_afterwards(child)) {
            node->children[i] = child->children[0];
            node->children[i]->parent = node;
        } else {
            leave_steps_out(child);
        }
    }
}

const ir_node *lvalue_before_steps(arena *a, const ir_node *lvalue) {
    const ir_node *statement = expression_place(lvalue);
    bool has_other = false;
    if (!statement || !has_lone_steps(lvalue, statement, &has_other) || has_other)
        return lvalue;
    ir_node *copy = ir_substitute(a, lvalue, NULL, NULL);
    copy->parent = NULL;
    leave_steps_out(copy);
    return copy;
}
