/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/memory/update_group.h"

#include <assert.h>

#include "analysis/base/expression.h"

/* The statements from `from` to `to` of a block. */
typedef struct range_of_block {
    variable_facts *facts;
    const ir_node *block;
    unsigned from, to;
    const ir_variable *variable;
    const ir_node *store;
} range_of_block;

static bool is_in_range(const range_of_block *r, const ir_node *node) {
    assert(r->from <= r->to && r->to < r->block->child_count);
    for (unsigned i = r->from; i <= r->to; i++)
        if (ir_contains(r->block->children[i], node))
            return true;
    return false;
}

static bool occurs_in_range_only(const range_of_block *r, const ir_variable *variable) {
    const variable_fact *fact = variable_fact_of(r->facts, variable);
    for (unsigned i = 0; i < fact->occurrences.count; i++)
        if (!is_in_range(r, fact->occurrences.items[i]))
            return false;
    return true;
}

static bool is_declared_in_range(const range_of_block *r, const ir_variable *variable) {
    const ir_node *declarator = variable_fact_of(r->facts, variable)->declarator;
    return declarator && is_in_range(r, declarator);
}

static bool is_own(const range_of_block *r, const ir_variable *variable) {
    return variable == r->variable || is_declared_in_range(r, variable);
}

static bool may_be_between(const range_of_block *r, const ir_node *node) {
    const ir_node *target = expression_written(node);
    switch (node->kind) {
    case IR_BREAK:
    case IR_CONTINUE:
    case IR_RETURN:
    case IR_GOTO:
    case IR_LABEL:
    case IR_CASE:
    case IR_DEFAULT:
    case IR_OPAQUE:
        return false;
    case IR_DECLARATOR:
        return node->variable->storage == IR_LOCAL && occurs_in_range_only(r, node->variable);
    default:
        break;
    }
    if (!ir_is_expression(node) && node->flags & IR_FROM_MACRO)
        return false;
    return node == r->store || !target ||
           (target->kind == IR_VARIABLE && is_own(r, target->variable));
}

static bool all_may_be_between(const range_of_block *r, const ir_node *node) {
    if (!may_be_between(r, node))
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!all_may_be_between(r, node->children[i]))
            return false;
    return true;
}

static bool mentions_own(const range_of_block *r, const ir_node *node) {
    if (node->kind == IR_VARIABLE && is_own(r, node->variable))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (mentions_own(r, node->children[i]))
            return true;
    return false;
}

/* The value that the statement loads into the variable; NULL if the statement does anything
 * else. */
static const ir_node *loaded(const ir_node *statement, const ir_variable *variable) {
    const ir_node *only = statement->child_count == 1 ? statement->children[0] : NULL;
    if (!only)
        return NULL;
    if (statement->kind == IR_DECLARATION)
        return only->variable == variable ? ir_child(only, 0) : NULL;
    return statement->kind == IR_EXPRESSION && only->kind == IR_ASSIGN && only->op == IR_OP_NONE &&
                   only->children[0]->kind == IR_VARIABLE && only->children[0]->variable == variable
               ? only->children[1]
               : NULL;
}

static bool is_plain_scalar(const ir_variable *variable) {
    return variable->storage == IR_LOCAL && ir_type_is_scalar(variable->type) &&
           variable->type->kind != IR_POINTER && !variable->address_taken &&
           !variable->type->is_volatile && !variable->type->is_atomic;
}

/* Searches the variables in the stored value for one into which an earlier statement loads the
 * element. */
static bool find_load(range_of_block *r, const ir_node *value, const ir_node *target,
                      update_group *group) {
    if (value->kind == IR_VARIABLE && is_plain_scalar(value->variable)) {
        r->variable = value->variable;
        for (r->from = r->to; r->from-- > 0;) {
            const ir_node *element = loaded(r->block->children[r->from], value->variable);
            if (!element || !expression_same(element, target))
                continue;
            bool is_found = occurs_in_range_only(r, value->variable) && !mentions_own(r, target);
            for (unsigned i = r->from; i <= r->to && is_found; i++)
                is_found = all_may_be_between(r, r->block->children[i]);
            *group =
                (update_group){r->block->children[r->from], r->block->children[r->to], element};
            return is_found;
        }
    }
    for (unsigned i = 0; i < value->child_count; i++)
        if (find_load(r, value->children[i], target, group))
            return true;
    return false;
}

bool update_group_of(variable_facts *facts, const ir_node *assignment, update_group *group) {
    const ir_node *statement = assignment->parent;
    const ir_node *block = statement ? statement->parent : NULL;
    if (assignment->kind != IR_ASSIGN || assignment->op != IR_OP_NONE || !block ||
        statement->kind != IR_EXPRESSION || block->kind != IR_BLOCK ||
        assignment->children[0]->kind == IR_VARIABLE ||
        !expression_is_plain(assignment->children[0]))
        return false;
    range_of_block r = {.facts = facts, .block = block, .store = assignment};
    while (block->children[r.to] != statement)
        r.to++;
    return find_load(&r, assignment->children[1], assignment->children[0], group);
}

/* The variable that is set to the value of this read; NULL if there is none. */
static const ir_variable *loaded_by(const ir_node *read) {
    const ir_node *load = read->parent;
    if (!load)
        return NULL;
    if (load->kind == IR_DECLARATOR)
        return load->variable;
    return load->kind == IR_ASSIGN && load->op == IR_OP_NONE && load->children[1] == read &&
                   load->children[0]->kind == IR_VARIABLE
               ? load->children[0]->variable
               : NULL;
}

static bool stores_back(const ir_node *statement, const ir_variable *variable,
                        const ir_node *element) {
    const ir_node *store = statement->kind == IR_EXPRESSION ? statement->children[0] : statement;
    return store->kind == IR_ASSIGN && store->op == IR_OP_NONE &&
           expression_same(store->children[0], element) &&
           expression_mentions(store->children[1], variable);
}

const ir_variable *update_group_holder(const ir_node *read) {
    const ir_variable *variable = loaded_by(read);
    const ir_node *block = variable && read->parent->parent ? read->parent->parent->parent : NULL;
    if (!block || block->kind != IR_BLOCK || !is_plain_scalar(variable))
        return NULL;
    for (unsigned i = 0; i < block->child_count; i++)
        if (block->children[i]->id > read->id && stores_back(block->children[i], variable, read))
            return variable;
    return NULL;
}

bool update_group_has(const update_group *group, const ir_node *node) {
    const ir_node *block = group->first->parent;
    assert(group->last->parent == block && group->first->id <= group->last->id);
    while (node && node->parent != block)
        node = node->parent;
    return node && node->id >= group->first->id && node->id <= group->last->id;
}
