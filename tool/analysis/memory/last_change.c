/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/memory/last_change.h"

#include <assert.h>

#include "analysis/base/expression.h"

static const last_change unknown = {CHANGE_UNKNOWN, NULL};
static const last_change none = {CHANGE_NONE, NULL};

/* The only change of the variable in an expression statement or a declaration. NULL if there are
 * several, or if the change is a part of a larger expression. */
static const ir_node *single_change(variable_facts *facts, const ir_variable *variable,
                                    const ir_node *statement) {
    const ir_node *change = NULL;
    if (statement->kind != IR_EXPRESSION && statement->kind != IR_DECLARATION)
        return NULL;
    for (unsigned i = 0; i < statement->child_count; i++) {
        const ir_node *part = statement->children[i];
        if (!variable_written_in(facts, part, variable))
            continue;
        const ir_node *target = expression_written(part);
        const bool is_set = part->kind == IR_DECLARATOR
                                ? part->variable == variable && part->child_count == 1
                                : target && expression_is_variable(target, variable);
        for (unsigned k = 0; k < part->child_count; k++)
            if (part->children[k] != target &&
                variable_written_in(facts, part->children[k], variable))
                return NULL;
        if (!is_set || change)
            return NULL;
        change = part;
    }
    return change;
}

last_change last_change_in(variable_facts *facts, const ir_variable *variable,
                           const ir_node *branch) {
    if (ir_holds_case(branch)) /* a jump to the case may skip the change */
        return unknown;
    if (!variable_written_in(facts, branch, variable))
        return none;
    if (branch->kind == IR_IF)
        return variable_written_in(facts, branch->children[0], variable)
                   ? unknown
                   : (last_change){CHANGE_IF, branch};
    if (branch->kind == IR_BLOCK)
        for (unsigned i = branch->child_count; i-- > 0;)
            if (variable_written_in(facts, branch->children[i], variable))
                return last_change_in(facts, variable, branch->children[i]);
    const ir_node *change = single_change(facts, variable, branch);
    return change ? (last_change){CHANGE_SET, change} : unknown;
}

/* The last change before `statement` in the block that contains it. */
static last_change change_above(variable_facts *facts, const ir_variable *variable,
                                const ir_node *statement) {
    assert(statement->parent->kind == IR_BLOCK);
    const ir_node *block = statement->parent;
    unsigned i = 0;
    while (block->children[i] != statement)
        i++;
    while (i-- > 0) {
        const last_change found = last_change_in(facts, variable, block->children[i]);
        if (found.kind != CHANGE_NONE)
            return found;
    }
    return none;
}

/* The last change in the statement itself before the site. CHANGE_NONE if the site is evaluated
 * first. */
static last_change change_within(variable_facts *facts, const ir_variable *variable,
                                 const ir_node *statement, const ir_node *site) {
    if (!variable_written_in(facts, statement->kind == IR_IF ? statement->children[0] : statement,
                             variable))
        return none;
    const ir_node *change = single_change(facts, variable, statement);
    if (!change)
        return unknown;
    return change->id < site->id && !ir_contains(change, site) ? (last_change){CHANGE_SET, change}
                                                               : none;
}

/* The last change in the node around `part` that happens before `part` is executed. */
static last_change change_around(variable_facts *facts, const ir_variable *variable,
                                 const ir_node *part) {
    const ir_node *around = part->parent;
    if (ir_holds_case(part)) /* a jump to the case skips the statements above it */
        return variable_written_in(facts, around, variable) ? unknown : none;
    if (around->kind == IR_BLOCK)
        return change_above(facts, variable, part);
    const bool is_branch = around->kind == IR_IF && part != around->children[0];
    return variable_written_in(facts, is_branch ? around->children[0] : around, variable) ? unknown
                                                                                          : none;
}

last_change last_change_before(variable_facts *facts, const ir_function *function,
                               const ir_variable *variable, const ir_node *site) {
    const ir_node *body = function->body, *part = site;
    if (!ir_contains(body, site) || variable_facts_has_jump(facts, function))
        return unknown;
    while (ir_is_expression(part) || part->kind == IR_DECLARATOR)
        part = part->parent;
    last_change found = change_within(facts, variable, part, site);
    for (; found.kind == CHANGE_NONE && part != body; part = part->parent)
        found = change_around(facts, variable, part);
    return found;
}
