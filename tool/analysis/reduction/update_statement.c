/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/reduction/update_statement.h"

#include "analysis/base/expression.h"

/* Does every evaluation of the expression read the element? Then its address can be computed before
 * the expression. */
static bool always_reads(const ir_node *node, const ir_node *element) {
    if (expression_same(node, element))
        return true;
    switch (node->kind) {
    case IR_SIZEOF:
    case IR_OPAQUE:
        return false;
    case IR_CONDITIONAL:
        return always_reads(node->children[0], element);
    case IR_BINARY:
        return always_reads(node->children[0], element) ||
               (node->op != IR_OP_AND && node->op != IR_OP_OR &&
                always_reads(node->children[1], element));
    default:
        for (unsigned i = 0; i < node->child_count; i++)
            if (always_reads(node->children[i], element))
                return true;
        return false;
    }
}

static bool is_write_of(const ir_node *expression, const ir_node *element) {
    const ir_node *written = expression_written(expression);
    return written && expression_same(written, element);
}

/* Do all expression statements in the statement assign the element? The conditions in it are not
 * examined, and its expressions may have other effects. */
static bool writes_only(const ir_node *statement, const ir_node *element) {
    switch (statement->kind) {
    case IR_EMPTY:
        return true;
    case IR_EXPRESSION:
        return is_write_of(statement->children[0], element);
    case IR_BLOCK:
        for (unsigned i = 0; i < statement->child_count; i++)
            if (!writes_only(statement->children[i], element))
                return false;
        return true;
    case IR_IF:
        for (unsigned i = 1; i < statement->child_count; i++)
            if (!writes_only(statement->children[i], element))
                return false;
        return true;
    default:
        return false;
    }
}

const ir_node *update_statement(const loop_analysis *j, const ir_node *target) {
    const ir_node *assignment = target->parent;
    if (!assignment || !assignment->parent || assignment->parent->kind != IR_EXPRESSION ||
        ir_value_is_used(assignment))
        return NULL;
    const ir_node *found = assignment->parent;
    for (const ir_node *outer = found->parent;
         outer && outer != j->loop && (outer->kind == IR_BLOCK || outer->kind == IR_IF);
         outer = outer->parent)
        if (outer->kind == IR_IF && always_reads(outer->children[0], target) &&
            writes_only(outer, target))
            found = outer;
    return found;
}

bool update_statement_reads_itself(const loop_access *read, const ir_node *statement,
                                   const ir_node *target) {
    return read->access.kind == ACCESS_READ && !read->access.callee && read->access.lvalue &&
           ir_contains(statement, read->access.node) &&
           expression_same(read->access.lvalue, target);
}

bool is_read_of_own_element(const loop_analysis *j, const loop_access *read) {
    const ir_node *element = read->access.lvalue;
    if (read->access.kind != ACCESS_READ || read->access.callee || !element)
        return false;
    for (const ir_node *node = read->access.node; node && node != j->loop; node = node->parent) {
        if (node->kind == IR_EXPRESSION && is_write_of(node->children[0], element))
            return true;
        if (node->kind == IR_IF && always_reads(node->children[0], element) &&
            writes_only(node, element))
            return true;
        if (!ir_is_expression(node) && node->kind != IR_EXPRESSION && node->kind != IR_BLOCK &&
            node->kind != IR_IF)
            return false;
    }
    return false;
}
