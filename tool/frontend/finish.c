/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Finishes the unit after all trees are complete: sorts and numbers functions and variables, and
 * sets address_taken. */
#include "frontend/convert.h"

#include "frontend/flags.h"
#include "ir/ir_accessors.h"
#include <assert.h>

/* ---- addresses taken ------------------------------------------------------------------------ */

/* The variable that contains the object `node`; NULL if the object is reached through a pointer. */
static ir_variable *object_of(const ir_node *node) {
    for (;;) {
        bool is_part = (node->kind == IR_MEMBER && !(node->flags & IR_ARROW)) ||
                       (node->kind == IR_INDEX && node->children[0]->type->kind == IR_ARRAY);
        if (!is_part)
            return node->kind == IR_VARIABLE ? node->variable : NULL;
        node = node->children[0];
    }
}

/* Does this use of an array make its address a value? False if the array is subscripted,
 * dereferenced or passed to a function. */
static bool lets_array_escape(const ir_node *array) {
    const ir_node *parent = array->parent;
    if (parent == NULL)
        return true;
    switch (parent->kind) {
    case IR_INDEX:
    case IR_CALL:
        return false;
    case IR_MEMBER:
        return false;
    case IR_UNARY:
        return parent->op != IR_OP_DEREFERENCE && parent->op != IR_OP_ADDRESS;
    case IR_EXPRESSION:
        return false;
    default:
        return true;
    }
}

static bool note_addresses(ir_node *node, void *context) {
    (void)context;
    ir_variable *object = NULL;
    if (node->kind == IR_UNARY && node->op == IR_OP_ADDRESS)
        object = object_of(node->children[0]);
    else if (node->type != NULL && node->type->kind == IR_ARRAY && lets_array_escape(node))
        object = object_of(node);
    if (object != NULL)
        object->address_taken = true;
    return true;
}

/* ---- order --------------------------------------------------------------------------------- */

static void number_variable(ir_unit *unit, ir_variable *v) {
    if (v->id != 0)
        return;
    unit->variables[unit->variable_count++] = v;
    v->id = unit->variable_count; /* the number + 1, until all variables are numbered */
}

static bool number_declared(ir_node *node, void *context) {
    if (node->kind == IR_DECLARATOR)
        number_variable(context, node->variable);
    return true;
}

static void number_variables(converter *c) {
    ir_unit *unit = c->unit;
    unit->variables = ARENA_ARRAY(c->arena, ir_variable *, c->found.count + 1u);
    for (unsigned i = 0; i < c->found.count; i++)
        if (c->found.items[i]->function == NULL)
            number_variable(unit, c->found.items[i]);
    for (unsigned i = 0; i < unit->function_count; i++) {
        const ir_function *f = unit->functions[i];
        for (unsigned k = 0; k < f->parameter_count; k++)
            number_variable(unit, f->parameters[k]);
        if (f->body != NULL)
            ir_walk(f->body, number_declared, unit);
    }
    for (unsigned i = 0; i < c->found.count; i++)
        number_variable(unit, c->found.items[i]);
    assert(unit->variable_count == c->found.count);
    for (unsigned i = 0; i < unit->variable_count; i++)
        unit->variables[i]->id = i;
}

static void order_functions(converter *c) {
    ir_unit *unit = c->unit;
    unit->functions = ARENA_ARRAY(c->arena, ir_function *, c->mains.count + c->others.count + 1u);
    for (unsigned i = 0; i < c->mains.count; i++)
        unit->functions[unit->function_count++] = c->mains.items[i];
    for (unsigned i = 0; i < c->others.count; i++)
        unit->functions[unit->function_count++] = c->others.items[i];
    for (unsigned i = 0; i < unit->function_count; i++)
        unit->functions[i]->id = i;
}

/* Marks functions that another definition may replace: a program may define a symbol that a shared
 * object exports too. */
static void mark_interposable(converter *c) {
    const parse_flags *chosen = c->compiler.flags;
    for (unsigned i = 0; i < c->unit->function_count; i++) {
        ir_function *function = c->unit->functions[i];
        function->linkage.is_interposable =
            chosen->may_be_interposed && !chosen->no_interposition && function->body != NULL &&
            !function->linkage.is_weak && !function->linkage.is_hidden;
        function->linkage.is_weak |= function->linkage.is_interposable;
    }
}

void finish_unit(converter *c) {
    order_functions(c);
    number_variables(c);
    for (unsigned i = 0; i < c->unit->variable_count; i++)
        assert(c->unit->variables[i]->id == i); /* the id is used as an index of arrays of
                                                 * facts */
    mark_interposable(c);
    for (unsigned i = 0; i < c->unit->function_count; i++)
        assert(c->unit->functions[i]->id == i);
    ir_look_through_accessors(c->unit);
    for (unsigned i = 0; i < c->unit->function_count; i++) {
        ir_function *f = c->unit->functions[i];
        ir_finish_function(f);
        if (f->body == NULL)
            continue;
        ir_walk(f->body, note_addresses, NULL);
        find_own_bytes(c, f->body);
    }
    ir_count_references(c->unit);
}
