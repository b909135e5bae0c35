/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Creates nodes, finishes functions, and substitutes arguments for parameters. */
#include "ir/ir.h"

#include <assert.h>

ir_node *ir_new(arena *a, ir_kind kind, const ir_type *type, unsigned child_count) {
    assert((unsigned)kind <= IR_EMPTY);
    assert(!type || kind <= IR_OPAQUE);
    ir_node *node = ARENA_NEW(a, ir_node);
    node->kind = kind;
    node->type = type;
    node->child_count = child_count;
    if (child_count > 0)
        node->children = ARENA_ARRAY(a, ir_node *, child_count);
    return node;
}

static void number_nodes(ir_node *node, ir_node *parent, unsigned *next_id) {
    node->parent = parent;
    node->id = (*next_id)++;
    for (unsigned i = 0; i < node->child_count; i++)
        number_nodes(node->children[i], node, next_id);
}

void ir_finish_function(ir_function *function) {
    assert(!function->body || function->body->kind == IR_BLOCK);
    function->node_count = 0;
    if (function->body != NULL)
        number_nodes(function->body, NULL, &function->node_count);
}

static bool count_reference(ir_node *node, void *context) {
    (void)context;
    if (node->kind == IR_FUNCTION)
        node->function->reference_count++;
    return true;
}

void ir_count_references(ir_unit *unit) {
    for (unsigned i = 0; i < unit->function_count; i++)
        unit->functions[i]->reference_count = 0;
    for (unsigned i = 0; i < unit->function_count; i++)
        if (unit->functions[i]->body != NULL)
            ir_walk(unit->functions[i]->body, count_reference, NULL);
}

/* ---- substitution -------------------------------------------------------------------------- */

static ir_node *copy_one(arena *a, const ir_node *node) {
    ir_node *copy = ir_new(a, node->kind, node->type, node->child_count);
    ir_node **children = copy->children;
    *copy = *node;
    copy->children = children;
    copy->parent = NULL;
    copy->id = 0;
    return copy;
}

static bool is_scalar_or_array(const ir_type *type) {
    return ir_type_is_scalar(type) || type->kind == IR_ARRAY;
}

/* Does passing a value of type `from` to a parameter of type `to` leave the value unchanged? */
static bool passes_unchanged(const ir_type *from, const ir_type *to) {
    if (from == NULL || to == NULL || !is_scalar_or_array(from) || !ir_type_is_scalar(to))
        return true;
    if (from->kind == IR_ARRAY)
        return to->kind == IR_POINTER && ir_type_equal(from->target, to->target);
    return ir_type_equal(from, to);
}

static ir_node *copy_argument(arena *a, const ir_node *argument, const ir_variable *parameter) {
    ir_node *copy = ir_substitute(a, argument, NULL, NULL);
    if (passes_unchanged(argument->type, parameter->type))
        return copy;
    ir_node *cast = ir_new(a, IR_CAST, parameter->type, 1);
    cast->range = argument->range;
    cast->flags = argument->flags & IR_FROM_MACRO;
    cast->children[0] = copy;
    copy->parent = cast;
    return cast;
}

static ir_node *argument_for(const ir_node *node, const ir_function *function,
                             ir_node *const *arguments) {
    if (node->kind != IR_VARIABLE || function == NULL)
        return NULL;
    for (unsigned i = 0; i < function->parameter_count; i++)
        if (function->parameters[i] == node->variable) {
            assert(!arguments[i] || ir_is_expression(arguments[i]));
            return arguments[i];
        }
    return NULL;
}

/* Rewrites (&x)->m as x.m. */
static void look_through_address(ir_node *node) {
    ir_node *pointer = node->kind == IR_MEMBER ? node->children[0] : NULL;
    if (pointer == NULL || !(node->flags & IR_ARROW) || pointer->kind != IR_UNARY ||
        pointer->op != IR_OP_ADDRESS)
        return;
    node->flags &= ~(unsigned)IR_ARROW;
    node->children[0] = pointer->children[0];
    node->children[0]->parent = node;
}

ir_node *ir_substitute(arena *a, const ir_node *expression, const ir_function *function,
                       ir_node *const *arguments) {
    assert(ir_is_expression(expression));
    const ir_node *argument = argument_for(expression, function, arguments);
    if (argument != NULL)
        return copy_argument(a, argument, expression->variable);
    ir_node *copy = copy_one(a, expression);
    for (unsigned i = 0; i < copy->child_count; i++) {
        copy->children[i] = ir_substitute(a, expression->children[i], function, arguments);
        copy->children[i]->parent = copy;
    }
    look_through_address(copy);
    return copy;
}
