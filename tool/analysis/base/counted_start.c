/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* What a for loop's header does before the first iteration. */
#include "analysis/base/counted_start.h"

#include "analysis/base/expression.h"

/* ---- declarations ---------------------------------------------------------------------------- */

static const ir_node *declarator_of(const ir_node *declaration, const ir_variable *variable) {
    for (unsigned i = 0; i < declaration->child_count; i++)
        if (declaration->children[i]->variable == variable)
            return declaration->children[i];
    return NULL;
}

static bool mentions_declared(const ir_node *node, const ir_node *declaration,
                              const ir_variable *except) {
    for (unsigned i = 0; i < declaration->child_count; i++)
        if (declaration->children[i]->variable != except &&
            expression_mentions(node, declaration->children[i]->variable))
            return true;
    return false;
}

/* for (int t = 0, last = n - 1; t <= last; t++): with the value of `last`, where that is all there
 * is of it, in its place. */
bool counted_split_declaration(const ir_node *loop, const ir_node *declaration,
                               counted_loop *counted) {
    const ir_node *own = declarator_of(declaration, counted->counter);
    const ir_variable *counter = counted->counter;
    if (!own || !own->child_count)
        return false;
    counted->lower = own->children[0];
    counted->counter_is_declared_in_header = true;
    if (declaration->child_count == 1)
        return true;
    const ir_node *bound = counted->bound->kind == IR_VARIABLE
                               ? declarator_of(declaration, counted->bound->variable)
                               : NULL;
    if (bound) {
        const ir_type *type = bound->variable->type;
        if (!bound->child_count || type->is_volatile || type->is_atomic ||
            !ir_type_equal(type, bound->children[0]->type))
            return false;
        counted->bound = bound->children[0];
    }
    for (unsigned i = 0; i < declaration->child_count; i++)
        if (declaration->children[i]->child_count &&
            !expression_is_plain(declaration->children[i]->children[0]))
            return false;
    return !mentions_declared(counted->lower, declaration, NULL) &&
           !mentions_declared(counted->bound, declaration, NULL) &&
           !mentions_declared(loop->children[2], declaration, counter) &&
           !mentions_declared(counted->body, declaration, counter);
}

/* The value that an assignment of the variable by = gives it; NULL: it is none. */
static const ir_node *assigned_value(const ir_node *node, const ir_variable *variable) {
    return node->kind == IR_ASSIGN && node->op == IR_OP_NONE &&
                   expression_is_variable(node->children[0], variable)
               ? node->children[1]
               : NULL;
}

/* for (v = base, end = g->n; v < end; v++): with the value of `end`, where that is all the loop
 * does with it, in its place. */
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

/* for (i = 0, q = 5; ...): a variable beside the counter is set, by what nothing else there sets.
 */
static bool split_start(const ir_node *node, counted_loop *counted) {
    const ir_node *target = node->kind == IR_ASSIGN ? node->children[0] : NULL;
    if (!target || target->kind != IR_VARIABLE || target->variable == counted->counter ||
        counted->start_count == sizeof counted->starts / sizeof counted->starts[0] ||
        !assigned_value(node, target->variable) || !expression_is_plain(node->children[1]) ||
        expression_mentions(counted->bound, target->variable))
        return false;
    counted->starts[counted->start_count++] = node;
    return true;
}

static bool mentions_start(const ir_node *node, const counted_loop *counted) {
    for (unsigned i = 0; i < counted->start_count; i++)
        if (expression_mentions(node, counted->starts[i]->children[0]->variable))
            return true;
    return false;
}

/* Do the values depend on nothing that the initialisation sets, nor is one set twice? */
static bool starts_are_apart(const counted_loop *counted) {
    if (mentions_start(counted->lower, counted) || mentions_start(counted->bound, counted))
        return false;
    for (unsigned i = 0; i < counted->start_count; i++) {
        const ir_node *start = counted->starts[i];
        if (mentions_start(start->children[1], counted) ||
            expression_mentions(start->children[1], counted->counter) ||
            (counted->bound_variable &&
             expression_mentions(start->children[1], counted->bound_variable)))
            return false;
        for (unsigned k = 0; k < i; k++)
            if (counted->starts[k]->children[0]->variable == start->children[0]->variable)
                return false;
    }
    return true;
}

static const ir_node *start_of_counter(const ir_node *node, const ir_variable *counter) {
    if (node->kind != IR_BINARY || node->op != IR_OP_COMMA)
        return assigned_value(node, counter);
    const ir_node *left = start_of_counter(node->children[0], counter);
    return left ? left : start_of_counter(node->children[1], counter);
}

static bool split_others(const ir_node *loop, const ir_node *node, counted_loop *counted) {
    if (node->kind == IR_BINARY && node->op == IR_OP_COMMA)
        return split_others(loop, node->children[0], counted) &&
               split_others(loop, node->children[1], counted);
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
    return counted->lower && split_others(loop, node, counted) && starts_are_apart(counted);
}
