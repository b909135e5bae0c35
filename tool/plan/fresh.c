/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A place is the variable, or one member of it. Statements are classified in the order of their
 * execution: what follows an assignment that is always executed is not looked at. Control leaves a
 * statement early only by `continue`, `break` or `return`, and then does not reach what follows it.
 */
#include "plan/fresh.h"

#include "analysis/base/expression.h"

typedef struct place {
    const ir_variable *variable;
    const ir_field *field; /* NULL: all of it */
} place;

typedef enum finding {
    READS,   /* perhaps before it is assigned */
    FRESH,   /* not so */
    ASSIGNS, /* moreover, it is assigned whenever the next statement is reached */
} finding;

static bool is_place(const place *p, const ir_node *node) {
    if (!p->field)
        return expression_is_variable(node, p->variable);
    return node->kind == IR_MEMBER && !(node->flags & IR_ARROW) && node->field &&
           node->field->offset == p->field->offset &&
           expression_is_variable(node->children[0], p->variable);
}

static bool mentions(const place *p, const ir_node *node) {
    if (is_place(p, node))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (mentions(p, node->children[i]))
            return true;
    return false;
}

static finding find_in(const place *p, const ir_node *node);

/** Parts that are executed one after the other. */
static finding in_turn(const place *p, ir_node *const *parts, unsigned count) {
    for (unsigned i = 0; i < count; i++) {
        const finding found = find_in(p, parts[i]);
        if (found != FRESH)
            return found;
    }
    return FRESH;
}

static finding in_assignment(const place *p, const ir_node *node) {
    const ir_node *target = node->children[0];
    const finding value = find_in(p, node->children[1]);
    if (value != FRESH)
        return value;
    if (is_place(p, target))
        return node->op == IR_OP_NONE ? ASSIGNS : READS;
    return mentions(p, target) ? READS : FRESH;
}

static finding in_choice(const place *p, const ir_node *node) {
    const finding condition = find_in(p, node->children[0]);
    if (condition != FRESH)
        return condition;
    const finding one = find_in(p, node->children[1]);
    const finding other = node->child_count > 2 ? find_in(p, node->children[2]) : FRESH;
    if (one == READS || other == READS)
        return READS;
    return one == ASSIGNS && other == ASSIGNS ? ASSIGNS : FRESH;
}

/** Its body may be executed not at all, and `continue` may leave it anywhere. */
static finding in_for(const place *p, const ir_node *node) {
    const finding first = find_in(p, node->children[0]);
    if (first != FRESH)
        return first;
    if (mentions(p, node->children[1]) || mentions(p, node->children[2]))
        return READS;
    return find_in(p, node->children[3]) == READS ? READS : FRESH;
}

static finding find_in(const place *p, const ir_node *node) {
    if (!mentions(p, node))
        return FRESH;
    switch (node->kind) {
    case IR_BLOCK:
    case IR_EXPRESSION:
    case IR_DECLARATION:
        return in_turn(p, node->children, node->child_count);
    case IR_ASSIGN:
        return in_assignment(p, node);
    case IR_BINARY:
        return node->op == IR_OP_COMMA ? in_turn(p, node->children, node->child_count) : READS;
    case IR_IF:
        return in_choice(p, node);
    case IR_FOR:
        return in_for(p, node);
    default:
        return READS;
    }
}

/** Its members, if the statement names nothing else of it; the number of fields, or 0. */
static bool names_only_members(const ir_node *node, const ir_variable *variable) {
    if (expression_is_variable(node, variable))
        return false;
    if (node->kind == IR_MEMBER && !(node->flags & IR_ARROW) &&
        expression_is_variable(node->children[0], variable))
        return ir_type_is_scalar(node->type) && node->field && !node->field->is_bit_field;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!names_only_members(node->children[i], variable))
            return false;
    return true;
}

bool is_fresh_in(const ir_node *statement, const ir_variable *variable) {
    if (variable->address_taken || variable->has_other_name || ir_has_kind(statement, IR_OPAQUE) ||
        ir_has_kind(statement, IR_GOTO) || ir_has_kind(statement, IR_SWITCH))
        return false;
    const ir_record *record = variable->type->record;
    if (ir_type_is_scalar(variable->type)) {
        const place whole = {variable, NULL};
        return find_in(&whole, statement) != READS;
    }
    if (variable->type->kind != IR_RECORD || !record || record->is_union ||
        !names_only_members(statement, variable))
        return false;
    for (unsigned i = 0; i < record->field_count; i++) {
        const place member = {variable, &record->fields[i]};
        if (find_in(&member, statement) == READS)
            return false;
    }
    return true;
}
