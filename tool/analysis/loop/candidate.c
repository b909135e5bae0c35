/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Finds the variables of a loop's body that depend on its counter, as a closure over assignments,
 * declarations, calls that may write to objects, and the conditions around them. An overestimate is
 * safe, because this only decides which loop of a nest is tried. */
#include "analysis/loop/candidate.h"

#include <assert.h>

#include "analysis/base/expression.h"
#include "analysis/base/library.h"
#include "support/vector.h"

typedef VECTOR(const ir_variable *) dependent_list;

typedef struct dependence {
    arena *memory;
    variable_facts *facts;
    effects *effects;
    dependent_list variables;
    dependent_list filled; /* variables to whose contents or targets a call may write values that
                            * depend on the counter */
    bool has_changed;
    bool has_update; /* there is an update whose element, or whose execution, depends on the
                      * counter */
} dependence;

/* Accepts loops of any form that counted_recognise_analysed recognises. Variables other than the
 * counter may be stepped in the header, because they do not affect the number of iterations. */
bool candidate_is_tiny(const ir_node *loop) {
    enum { TINY = 16 };
    const counted_result counted = counted_recognise_analysed((ir_node *)loop);
    int64_t lower, bound;
    if (!counted.is_counted || !counted.loop.lower || counted.loop.stride ||
        !expression_constant(counted.loop.lower, &lower) ||
        !expression_constant(counted.loop.bound, &bound))
        return false;
    const uint64_t distance =
        bound > lower ? (uint64_t)bound - (uint64_t)lower : (uint64_t)lower - (uint64_t)bound;
    return distance <= TINY;
}

/* Does the function contain no loop, and call only functions in the table of library.h and
 * functions for which is_straight is true as well? */
static bool is_straight(const ir_unit *unit, const ir_function *function, unsigned depth);

static bool calls_straight(const ir_unit *unit, const ir_node *callee, unsigned depth) {
    return callee->kind == IR_FUNCTION &&
           (library_find(unit, callee->function) || is_straight(unit, callee->function, depth));
}

static bool has_few_statements(const ir_unit *unit, const ir_node *node, unsigned depth) {
    if (ir_is_loop(node) ||
        (node->kind == IR_CALL && !calls_straight(unit, node->children[0], depth)))
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!has_few_statements(unit, node->children[i], depth))
            return false;
    return true;
}

static bool is_straight(const ir_unit *unit, const ir_function *function, unsigned depth) {
    enum { DEEPEST = 3 }; /* greatest depth of calls; also ends recursion */
    return function->body && depth < DEEPEST && has_few_statements(unit, function->body, depth + 1);
}

bool candidate_is_short(const ir_unit *unit, const ir_node *body) {
    if (ir_is_loop(body) && !candidate_is_tiny(body))
        return false;
    if (body->kind == IR_CALL && !calls_straight(unit, body->children[0], 0))
        return false;
    for (unsigned i = 0; i < body->child_count; i++)
        if (!candidate_is_short(unit, body->children[i]))
            return false;
    return true;
}

static bool is_in(const dependent_list *list, const ir_variable *variable) {
    for (unsigned i = 0; i < list->count; i++)
        if (list->items[i] == variable)
            return true;
    return false;
}

static bool depends(const dependence *d, const ir_node *node) {
    if (node->kind == IR_VARIABLE &&
        (is_in(&d->variables, node->variable) || is_in(&d->filled, node->variable)))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (depends(d, node->children[i]))
            return true;
    return false;
}

static void add_to(dependence *d, dependent_list *list, const ir_variable *variable) {
    if (!variable || is_in(list, variable))
        return;
    VECTOR_PUSH(d->memory, list, variable);
    d->has_changed = true;
}

static void add(dependence *d, const ir_variable *variable) {
    add_to(d, &d->variables, variable);
}

static bool is_pointer(const ir_variable *variable) {
    return variable->type->kind == IR_POINTER;
}

/* Does the element that this lvalue denotes depend on the counter? */
static bool address_depends(const dependence *d, const ir_node *lvalue) {
    if (lvalue->type && lvalue->type->kind == IR_ARRAY && lvalue->kind == IR_VARIABLE)
        return false;
    if (lvalue->kind == IR_INDEX)
        return depends(d, lvalue->children[1]) || address_depends(d, lvalue->children[0]);
    if (lvalue->kind == IR_MEMBER)
        return address_depends(d, lvalue->children[0]);
    return depends(d, lvalue);
}

static bool is_address(const ir_node *argument) {
    const ir_type *type = argument->type;
    return type && (type->kind == IR_POINTER || type->kind == IR_ARRAY);
}

/* Does the address that is passed change with the counter? The memory it points to does not count
 * here. */
static bool argument_depends(const dependence *d, const ir_node *argument) {
    switch (argument->kind) {
    case IR_VARIABLE:
        return !ir_is_array(argument) && is_in(&d->variables, argument->variable);
    case IR_INDEX:
        return argument_depends(d, argument->children[0]) || depends(d, argument->children[1]);
    case IR_MEMBER:
    case IR_UNARY:
    case IR_BINARY:
    case IR_CAST:
        for (unsigned i = 0; i < argument->child_count; i++)
            if (argument_depends(d, argument->children[i]))
                return true;
        return false;
    default:
        return depends(d, argument);
    }
}

/* Do the elements that the call may update depend on the counter? For add(&h[k], v) they do if an
 * address in the arguments depends on the counter. For add_at(h, k, v) they do if an integer in the
 * arguments does. */
static bool call_depends(const dependence *d, const ir_node *call) {
    bool has_address = false, is_of_array = true, is_elsewhere = false, has_subscript = false;
    for (unsigned i = 1; i < call->child_count; i++) {
        const ir_node *argument = call->children[i];
        if (is_address(argument)) {
            has_address = true;
            is_of_array &= argument->kind == IR_VARIABLE || argument->kind == IR_MEMBER;
            is_elsewhere |= argument_depends(d, argument);
        } else if (argument->type && argument->type->kind == IR_INTEGER) {
            has_subscript |= depends(d, argument);
        }
    }
    return is_elsewhere || (has_address && is_of_array && has_subscript);
}

/* Does the called function update memory other than the caller's automatic variables? */
static bool call_updates(const dependence *d, const ir_node *call) {
    access_list list = {0};
    access_collect(d->effects, call, &list);
    for (unsigned i = 0; i < list.items.count; i++) {
        const access *a = &list.items.items[i];
        const ir_variable *root = a->lvalue ? ir_root_variable(a->lvalue) : NULL;
        if (a->callee && a->kind == ACCESS_UPDATE && a->lvalue &&
            !(root && variable_is_automatic(root) && !is_pointer(root)))
            return true;
    }
    return false;
}

/* Handles a call of a function that may write to, or update, the targets of its arguments. */
static void visit_call(dependence *d, const ir_node *call, bool is_dependent) {
    if (!is_dependent && !depends(d, call))
        return;
    d->has_update |= (is_dependent || call_depends(d, call)) && call_updates(d, call);
    for (unsigned i = 1; i < call->child_count; i++)
        if (is_address(call->children[i]))
            add_to(d, &d->filled, ir_root_variable(call->children[i]));
}

/* The array w, if the lvalue is *p, *p++ or p[k] and p points into w; otherwise NULL. */
static const ir_variable *array_walked_by(const dependence *d, const ir_node *lvalue) {
    while (lvalue->kind != IR_VARIABLE && lvalue->child_count)
        lvalue = lvalue->children[0];
    const ir_node *array =
        lvalue->kind == IR_VARIABLE ? variable_walked_array(d->facts, lvalue->variable) : NULL;
    return array ? array->variable : NULL;
}

/* Handles a node of the body. `is_dependent` says that the counter decides whether the node is
 * executed. */
static void visit(dependence *d, const ir_node *node, bool is_dependent) {
    const ir_node *target = expression_written(node);
    if (target) {
        bool value_depends = is_dependent || address_depends(d, target) ||
                             (node->kind == IR_ASSIGN && depends(d, node->children[1]));
        /* a store through a pointer changes the array into which it points, but not the pointer */
        ir_variable *root = ir_root_variable(target);
        if (value_depends && root && (target->kind == IR_VARIABLE || !is_pointer(root)))
            add(d, root);
        else if (value_depends)
            add(d, array_walked_by(d, target));
        if (target->kind != IR_VARIABLE && (is_dependent || address_depends(d, target)))
            d->has_update = true;
    }
    if (node->kind == IR_DECLARATOR && node->child_count &&
        (is_dependent || depends(d, node->children[0])))
        add(d, node->variable);
    if (node->kind == IR_CALL)
        visit_call(d, node, is_dependent);
    bool controls = node->kind == IR_IF || node->kind == IR_SWITCH ||
                    node->kind == IR_CONDITIONAL || ir_is_loop(node) ||
                    (node->kind == IR_BINARY && node->op >= IR_OP_AND);
    for (unsigned i = 0; controls && i < node->child_count; i++)
        is_dependent =
            is_dependent || (ir_is_expression(node->children[i]) && depends(d, node->children[i]));
    for (unsigned i = 0; i < node->child_count; i++)
        visit(d, node->children[i], is_dependent);
}

bool candidate_varies(const analyser *an, const ir_node *loop) {
    assert(ir_is_loop(loop));
    counted_result counted = counted_recognise_analysed((ir_node *)loop);
    if (!counted.is_counted)
        return true;
    dependence d = {.memory = an->memory, .facts = an->facts, .effects = an->effects};
    add(&d, counted.loop.counter);
    do {
        d.has_changed = false;
        d.has_update = false;
        visit(&d, counted.loop.body, false);
    } while (d.has_changed);
    return d.has_update;
}
