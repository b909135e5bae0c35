/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/memory/search.h"

#include "analysis/base/expression.h"

/* Is the read evaluated whenever the condition is? */
static bool is_certain_in(const ir_node *condition, const ir_node *read) {
    for (const ir_node *node = read; node != condition; node = node->parent) {
        const ir_node *parent = node->parent;
        bool skips =
            parent->kind == IR_CONDITIONAL || parent->kind == IR_OPAQUE ||
            (parent->kind == IR_BINARY && (parent->op == IR_OP_AND || parent->op == IR_OP_OR));
        if (skips && parent->children[0] != node)
            return false;
    }
    return true;
}

static bool is_count_up(const ir_node *node, const ir_variable *cursor) {
    while (node->child_count == 1 && (node->kind == IR_BLOCK || node->kind == IR_EXPRESSION))
        node = node->children[0];
    return node->kind == IR_UNARY &&
           (node->op == IR_OP_PRE_INCREMENT || node->op == IR_OP_POST_INCREMENT) &&
           node->children[0]->kind == IR_VARIABLE && node->children[0]->variable == cursor;
}

/* Do the loop's body and increment do nothing but increment the cursor? */
static bool only_counts_up(const ir_node *loop, const ir_variable *cursor) {
    if (loop->kind == IR_WHILE)
        return is_count_up(loop->children[1], cursor);
    return loop->kind == IR_FOR && loop->children[0]->kind == IR_EMPTY &&
           ((loop->children[3]->kind == IR_EMPTY && is_count_up(loop->children[2], cursor)) ||
            (loop->children[2]->kind == IR_EMPTY && is_count_up(loop->children[3], cursor)));
}

static unsigned count_writes(const ir_node *node, const ir_variable *variable) {
    const ir_node *target = expression_written(node);
    unsigned count = target && target->kind == IR_VARIABLE && target->variable == variable;
    for (unsigned i = 0; i < node->child_count; i++)
        count += count_writes(node->children[i], variable);
    return count;
}

/* The cursor's initial value, from one of the declarations at the beginning of the body. NULL if
 * there is none. */
static const ir_node *initial_value(const ir_node *body, const ir_variable *cursor) {
    for (unsigned i = 0; i + 2 < body->child_count; i++) {
        const ir_node *declaration = body->children[i];
        if (declaration->kind != IR_DECLARATION)
            return NULL;
        for (unsigned k = 0; k < declaration->child_count; k++)
            if (declaration->children[k]->variable == cursor)
                return ir_child(declaration->children[k], 0);
    }
    return NULL;
}

static bool returns(const ir_node *statement, const ir_variable *cursor) {
    const ir_node *value = statement->kind == IR_RETURN ? ir_child(statement, 0) : NULL;
    return value && value->kind == IR_VARIABLE && value->variable == cursor;
}

/* Can the search not wrap around? Either the cursor's overflow is undefined, or the cursor has 8
 * bytes and would reach the end of all memory first. A narrower unsigned cursor would wrap around
 * to 0. */
static bool cannot_wrap(const ir_type *cursor) {
    return cursor->kind == IR_INTEGER && (cursor->size == 8 || ir_type_never_wraps(cursor));
}

const ir_node *search_start(const ir_function *function, const ir_node *read) {
    const ir_node *body = function->body;
    const ir_node *subscript = read->kind == IR_INDEX ? read->children[1] : NULL;
    if (!body || body->child_count < 3 || !subscript || subscript->kind != IR_VARIABLE)
        return NULL;
    const ir_variable *cursor = subscript->variable;
    const ir_node *loop = body->children[body->child_count - 2];
    if (cursor->storage != IR_LOCAL || cursor->address_taken || !cannot_wrap(cursor->type) ||
        !ir_type_equal(function->type->target, cursor->type) ||
        !returns(body->children[body->child_count - 1], cursor) || !only_counts_up(loop, cursor) ||
        count_writes(body, cursor) != 1)
        return NULL;
    const ir_node *condition = loop->children[loop->kind == IR_WHILE ? 0 : 1];
    if (!ir_contains(condition, read) || !is_certain_in(condition, read))
        return NULL;
    /* only declarations precede the loop, so every call reaches it */
    for (unsigned i = 0; i + 2 < body->child_count; i++)
        if (body->children[i]->kind != IR_DECLARATION)
            return NULL;
    return initial_value(body, cursor);
}
