/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Analyses the initialisation in a for loop's header. */
#include "analysis/base/counted_start.h"

#include <assert.h>

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"

/* ---- variables set, and their values --------------------------------------------------------- */

static bool add_start(counted_loop *counted, loop_start start) {
    if (counted->start_count == sizeof counted->starts / sizeof counted->starts[0] ||
        !expression_is_plain(start.value) || expression_mentions(counted->bound, start.variable))
        return false;
    counted->starts[counted->start_count++] = start;
    return true;
}

static bool mentions_start(const ir_node *node, const counted_loop *counted) {
    for (unsigned i = 0; i < counted->start_count; i++)
        if (expression_mentions(node, counted->starts[i].variable))
            return true;
    return false;
}

/* Is no variable set twice, and is no value computed from a variable that the initialisation
 * sets? */
static bool starts_are_independent(const counted_loop *counted) {
    assert(counted->lower && counted->bound);
    if (mentions_start(counted->lower, counted) || mentions_start(counted->bound, counted))
        return false;
    for (unsigned i = 0; i < counted->start_count; i++) {
        const loop_start *start = &counted->starts[i];
        if (mentions_start(start->value, counted) ||
            expression_mentions(start->value, counted->counter) ||
            (counted->bound_variable && expression_mentions(start->value, counted->bound_variable)))
            return false;
        for (unsigned k = 0; k < i; k++)
            if (counted->starts[k].variable == start->variable)
                return false;
    }
    return true;
}

/* ---- declarations ---------------------------------------------------------------------------- */

static const ir_node *declarator_of(const ir_node *declaration, const ir_variable *variable) {
    for (unsigned i = 0; i < declaration->child_count; i++)
        if (declaration->children[i]->variable == variable)
            return declaration->children[i];
    return NULL;
}

static bool mentions_declared(const ir_node *node, const ir_node *declaration) {
    for (unsigned i = 0; i < declaration->child_count; i++)
        if (expression_mentions(node, declaration->children[i]->variable))
            return true;
    return false;
}

/* Handles for (int t = 0, last = n - 1; t <= last; t++): the value of `last` becomes the bound.
 * Returns false if the loop may change `last`. */
static bool split_declared_bound(const ir_node *loop, const ir_node *declaration,
                                 counted_loop *counted) {
    const ir_node *bound = counted->bound->kind == IR_VARIABLE
                               ? declarator_of(declaration, counted->bound->variable)
                               : NULL;
    if (!bound)
        return true;
    const ir_type *type = bound->variable->type;
    if (!bound->child_count || type->is_volatile || type->is_atomic ||
        !ir_type_equal(type, bound->children[0]->type) ||
        variable_is_written_in(loop->children[2], bound->variable) ||
        variable_is_written_in(counted->body, bound->variable))
        return false;
    counted->bound = bound->children[0];
    return true;
}

/* The value in the declaration of a scalar: 5 in `q = 5` and `q = {5}`. */
static ir_node *value_declared(const ir_node *declarator) {
    ir_node *value = declarator->children[0];
    return value->kind == IR_INITIALIZERS && value->child_count == 1 ? value->children[0] : value;
}

/* Handles another declared variable, such as q in for (int t = 0, q = 5; t < n; t++, q += 3). */
static bool split_declared_start(const ir_node *loop, const ir_node *declarator,
                                 counted_loop *counted) {
    ir_variable *variable = declarator->variable;
    const bool is_used = expression_mentions(loop->children[2], variable) ||
                         expression_mentions(counted->body, variable);
    if (variable == counted->counter || !is_used)
        return !declarator->child_count || expression_is_plain(declarator->children[0]);
    return declarator->child_count &&
           add_start(counted, (loop_start){variable, value_declared(declarator), declarator, true});
}

bool counted_split_declaration(const ir_node *loop, const ir_node *declaration,
                               counted_loop *counted) {
    assert(declaration->kind == IR_DECLARATION);
    const ir_node *own = declarator_of(declaration, counted->counter);
    if (!own || !own->child_count)
        return false;
    counted->lower = value_declared(own);
    counted->counter_is_declared_in_header = true;
    if (declaration->child_count == 1)
        return true;
    if (!split_declared_bound(loop, declaration, counted))
        return false;
    for (unsigned i = 0; i < declaration->child_count; i++)
        if (!split_declared_start(loop, declaration->children[i], counted))
            return false;
    return !mentions_declared(counted->lower, declaration) &&
           !mentions_declared(counted->bound, declaration) && starts_are_independent(counted);
}

/* ---- assignments ----------------------------------------------------------------------------- */

/* Does the constant keep its value when it is converted to the type? */
static bool keeps_constant(const ir_type *type, int64_t value) {
    if (!ir_type_is_plain_integer(type))
        return false;
    const int bits = (int)type->size * 8 - (type->is_signed ? 1 : 0);
    if (bits >= 63)
        return type->is_signed || value >= 0;
    const int64_t end = (int64_t)1 << bits;
    return value < end && value >= (type->is_signed ? -end : 0);
}

static bool keeps_all(const ir_type *outer, const ir_type *inner) {
    return ir_type_equal(outer, inner) ||
           (ir_type_is_plain_integer(outer) && ir_type_is_plain_integer(inner) &&
            outer->is_signed == inner->is_signed && outer->size >= inner->size);
}

/* Returns e, the value that i gets in i = q = e. Returns NULL if storing e in q may change the
 * value. */
static const ir_node *chained_value(const ir_node *value) {
    while (value && value->kind == IR_ASSIGN && value->op == IR_OP_NONE &&
           value->children[0]->kind == IR_VARIABLE) {
        const ir_type *type = value->children[0]->variable->type;
        const ir_node *inner = chained_value(value->children[1]);
        int64_t constant;
        const bool is_kept = inner && !type->is_volatile && !type->is_atomic &&
                             (expression_constant(inner, &constant) ? keeps_constant(type, constant)
                                                                    : keeps_all(type, inner->type));
        value = is_kept ? inner : NULL;
    }
    return value;
}

/* The value that an assignment by = gives the variable; NULL if the node is no such assignment. */
static const ir_node *assigned_value(const ir_node *node, const ir_variable *variable) {
    return node->kind == IR_ASSIGN && node->op == IR_OP_NONE &&
                   expression_is_variable(node->children[0], variable)
               ? chained_value(node->children[1])
               : NULL;
}

/* Handles for (v = base, end = g->n; v < end; v++): the value of `end` becomes the bound, if the
 * loop uses `end` only in its condition. */
static bool split_bound(const ir_node *loop, const ir_node *node, counted_loop *counted) {
    const ir_variable *variable =
        counted->bound->kind == IR_VARIABLE ? counted->bound->variable : NULL;
    const ir_node *value = variable ? assigned_value(node, variable) : NULL;
    if (!value || !variable_is_automatic(variable) || variable->address_taken ||
        variable->type->is_volatile || variable->type->is_atomic ||
        !ir_type_equal(variable->type, value->type) || !expression_is_plain(value))
        return false;
    if (expression_mentions(value, variable) || expression_mentions(value, counted->counter) ||
        expression_mentions(counted->lower, variable) ||
        expression_mentions(loop->children[2], variable) ||
        expression_mentions(counted->body, variable))
        return false;
    counted->bound = value;
    counted->bound_variable = variable;
    return true;
}

/* Handles for (i = 0, q = 5; ...): notes a variable other than the counter that is set to an
 * independent value. */
static bool split_start(const ir_node *node, counted_loop *counted) {
    const ir_node *target = node->kind == IR_ASSIGN ? node->children[0] : NULL;
    if (!target || target->kind != IR_VARIABLE || target->variable == counted->counter)
        return false;
    const ir_node *value = assigned_value(node, target->variable);
    return value && add_start(counted, (loop_start){target->variable, value, node, false});
}

/* The value that a sequence or chain of assignments gives the counter; NULL if there is none. */
static const ir_node *start_of_counter(const ir_node *node, const ir_variable *counter) {
    const bool is_sequence = node->kind == IR_BINARY && node->op == IR_OP_COMMA;
    if (node->kind == IR_ASSIGN && expression_is_variable(node->children[0], counter))
        return assigned_value(node, counter);
    if (!is_sequence && node->kind != IR_ASSIGN)
        return NULL;
    const ir_node *left = is_sequence ? start_of_counter(node->children[0], counter) : NULL;
    return left ? left : start_of_counter(node->children[1], counter);
}

static bool split_others(const ir_node *loop, const ir_node *node, counted_loop *counted) {
    if (node->kind == IR_BINARY && node->op == IR_OP_COMMA)
        return split_others(loop, node->children[0], counted) &&
               split_others(loop, node->children[1], counted);
    if (node->kind != IR_ASSIGN)
        return false;
    if (node->children[1]->kind == IR_ASSIGN && !split_others(loop, node->children[1], counted))
        return false;
    return assigned_value(node, counted->counter) == counted->lower ||
           (!counted->bound_variable && split_bound(loop, node, counted)) ||
           split_start(node, counted);
}

bool counted_split_initialisation(const ir_node *loop, const ir_node *node, counted_loop *counted) {
    if (node->kind == IR_EXPRESSION)
        node = node->children[0];
    if (node->kind == IR_EMPTY)
        return true;
    counted->lower = start_of_counter(node, counted->counter);
    return counted->lower && split_others(loop, node, counted) && starts_are_independent(counted);
}
