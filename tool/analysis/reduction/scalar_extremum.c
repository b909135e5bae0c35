/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The compared values are stored, one per iteration. After the loop they are compared in order, by
 * the same comparison as in the sequential loop, so NaNs, signed zeros and equal values have the
 * same effect. */
#include "analysis/reduction/scalar_extremum.h"

#include "analysis/base/expression.h"
#include "analysis/loop/executed.h"

/* Does the condition compare the value with s? Sets *op to the operator of `value op s`. */
static bool compares(const ir_node *condition, const ir_node *value, const ir_variable *s,
                     ir_operator *op) {
    if (condition->kind != IR_BINARY || condition->op < IR_OP_LESS ||
        condition->op > IR_OP_GREATER_EQUAL)
        return false;
    const unsigned side = expression_is_variable(condition->children[0], s) ? 1 : 0;
    *op = side ? expression_mirrored(condition->op) : condition->op;
    return expression_is_variable(condition->children[1 - side], s) &&
           expression_same(condition->children[side], value);
}

/* Recognises s = e > s ? e : s, also with the branches exchanged. */
static bool is_selection(const ir_node *assignment, scalar_update *found) {
    const ir_node *value = assignment->children[1];
    ir_variable *s = assignment->children[0]->variable;
    if (value->kind != IR_CONDITIONAL)
        return false;
    found->is_negated = expression_is_variable(value->children[1], s);
    if (!expression_is_variable(value->children[found->is_negated ? 1 : 2], s))
        return false;
    found->variable = s;
    found->target = assignment->children[0];
    found->value = value->children[found->is_negated ? 2 : 1];
    return compares(value->children[0], found->value, s, &found->op);
}

static const ir_node *plain_assignment(const ir_node *statement) {
    const ir_node *node = statement->kind == IR_EXPRESSION ? statement->children[0] : NULL;
    return node && node->kind == IR_ASSIGN && node->op == IR_OP_NONE &&
                   node->children[0]->kind == IR_VARIABLE
               ? node
               : NULL;
}

/* Takes one of the statements under the condition: s = e, or at = i. Returns false if it has
 * another form. */
static bool take_statement(const loop_analysis *j, const ir_node *condition,
                           const ir_node *statement, scalar_update *found) {
    const ir_node *assignment = plain_assignment(statement);
    if (!assignment)
        return false;
    ir_variable *target = assignment->children[0]->variable;
    if (!found->variable && compares(condition, assignment->children[1], target, &found->op)) {
        found->variable = target;
        found->target = assignment->children[0];
        found->value = assignment->children[1];
        return true;
    }
    const bool is_place = !found->place && target->type->kind == IR_INTEGER &&
                          expression_is_variable(assignment->children[1], j->counted.counter);
    if (is_place)
        found->place = target;
    return is_place;
}

/* Recognises if (e > s) { s = e; at = i; }. */
static bool is_choice(const loop_analysis *j, const ir_node *choice, scalar_update *found) {
    const ir_node *then = choice->children[1];
    if (choice->child_count != 2)
        return false;
    if (then->kind != IR_BLOCK)
        return take_statement(j, choice->children[0], then, found) && found->variable;
    for (unsigned i = 0; i < then->child_count; i++)
        if (!take_statement(j, choice->children[0], then->children[i], found))
            return false;
    return found->variable != NULL;
}

/* Is the statement executed at most once in each iteration? */
static bool is_outside_inner_loops(const loop_analysis *j, const ir_node *statement) {
    for (const ir_node *outer = statement->parent; outer != j->loop; outer = outer->parent)
        if (!outer || ir_is_loop(outer))
            return false;
    return true;
}

static bool is_plain_type(const ir_type *type) {
    return !type->is_volatile && !type->is_atomic;
}

static bool is_fit(const loop_analysis *j, scalar_update *found) {
    const ir_variable *s = found->variable;
    const ir_node *value = found->value;
    if (!value->type || !ir_type_equal(value->type, s->type) || !is_plain_type(s->type) ||
        !is_plain_type(value->type) || !expression_is_plain(value) ||
        expression_mentions(value, s) || !is_outside_inner_loops(j, found->statement))
        return false;
    if (found->place && (found->place == s || found->place == j->counted.counter ||
                         !is_plain_type(found->place->type) || found->place->address_taken ||
                         expression_mentions(value, found->place)))
        return false;
    found->is_conditional = !executed_in_each(j, found->statement);
    return true;
}

bool scalar_extremum_of(const loop_analysis *j, const ir_node *assignment, scalar_update *found) {
    const ir_node *statement = assignment->parent;
    *found = (scalar_update){.statement = statement, .is_extremum = true};
    if (!statement || plain_assignment(statement) != assignment)
        return false;
    if (is_selection(assignment, found))
        return is_fit(j, found);
    const ir_node *choice = statement->parent;
    if (choice->kind == IR_BLOCK)
        choice = choice->parent;
    *found = (scalar_update){.statement = choice, .is_extremum = true};
    return choice && choice->kind == IR_IF && ir_contains(j->counted.body, choice) &&
           is_choice(j, choice, found) && is_fit(j, found);
}
