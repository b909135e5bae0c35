/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/inner_variables.h"

#include <assert.h>

#include "analysis/base/expression.h"
#include "ir/ir_syntax.h"

bool inner_statement_sets(const ir_node *statement, const ir_variable *variable) {
    if (statement->kind == IR_DECLARATION) {
        const ir_node *declarator = ir_declarator_in(statement, variable);
        return declarator && declarator->child_count > 0;
    }
    if (statement->kind == IR_EXPRESSION)
        statement = statement->children[0];
    return statement->kind == IR_ASSIGN && statement->op == IR_OP_NONE &&
           expression_is_variable(statement->children[0], variable);
}

/** Does the statement, or the initialisation of a `for`, set the variable, perhaps in one of
 *  several assignments separated by commas? */
static bool header_sets(const ir_node *start, const ir_variable *variable) {
    if (start->kind == IR_EXPRESSION)
        start = start->children[0];
    if (start->kind == IR_BINARY && start->op == IR_OP_COMMA)
        return header_sets(start->children[0], variable) ||
               header_sets(start->children[1], variable);
    return inner_statement_sets(start, variable);
}

typedef enum answer { ANSWER_NONE, ANSWER_SET, ANSWER_STALE } answer;

/** Searches backwards from `node` in its block for a statement that sets the variable.
 * ANSWER_STALE: the search has met `inner`, so the value may come from an iteration of that
 * loop. */
static answer search_before(const ir_node *block, const ir_node *node, const ir_node *inner,
                            const ir_variable *variable) {
    assert(node->parent == block);
    unsigned i = 0;
    while (block->children[i] != node)
        i++;
    while (i-- > 0) {
        if (ir_contains(block->children[i], inner))
            return ANSWER_STALE;
        const ir_node *before = block->children[i];
        if (header_sets(before->kind == IR_FOR ? before->children[0] : before, variable))
            return ANSWER_SET;
    }
    return ANSWER_NONE;
}

static answer search_around(const ir_node *node, const ir_node *inner,
                            const ir_variable *variable) {
    const ir_node *parent = node->parent;
    if (parent->kind == IR_BLOCK)
        return search_before(parent, node, inner, variable);
    if (!ir_is_loop(parent))
        return ANSWER_NONE;
    if (ir_contains(parent, inner)) /* the value may be from the preceding iteration of `inner` */
        return ANSWER_STALE;
    return parent->kind == IR_FOR && node != parent->children[0] &&
                   header_sets(parent->children[0], variable)
               ? ANSWER_SET
               : ANSWER_NONE;
}

static bool is_set_for(const ir_node *body, const ir_node *inner, const ir_node *read) {
    for (const ir_node *node = read; node != body; node = node->parent) {
        const answer found = search_around(node, inner, read->variable);
        if (found != ANSWER_NONE)
            return found == ANSWER_SET;
    }
    return false;
}

static bool are_reads_set(const ir_node *body, const ir_node *inner, const ir_node *node,
                          const ir_variable *variable) {
    if (node->kind == IR_VARIABLE && node->variable == variable && !expression_is_assigned(node) &&
        !is_set_for(body, inner, node))
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!are_reads_set(body, inner, node->children[i], variable))
            return false;
    return true;
}

bool inner_value_is_dead(const ir_node *body, const ir_node *inner, const ir_variable *variable) {
    assert(!variable->address_taken);
    assert(ir_contains(body, inner));
    const bool may_enter_blocks = ir_has_kind(body, IR_LABEL) || ir_has_kind(body, IR_SWITCH);
    return ir_type_is_scalar(variable->type) && !may_enter_blocks &&
           are_reads_set(body, inner, body, variable);
}
