/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ir/ir_accessors.h"

#include <assert.h>
#include <string.h>

#include "ir/ir_words.h"

/* nodes of one address. Nested accessor calls in arguments can multiply them */
enum { MOST_NODES = 200 };

typedef enum progress { UNSEEN, BEGUN, DONE } progress;

typedef struct accessors {
    arena *memory;
    const ir_unit *unit;
    progress *functions; /* state of each function, by its id */
} accessors;

static void look_through(accessors *a, ir_function *function);

static bool is_of_file(const ir_variable *variable) {
    return variable->storage == IR_GLOBAL || variable->storage == IR_STATIC ||
           variable->storage == IR_THREAD_LOCAL;
}

/* May the variable occur in the address: is it of file scope, or a parameter of `function`? False
 * for a parameter whose row length depends on the function's local variables. */
static bool can_be_named(const ir_variable *variable, const ir_function *function) {
    return is_of_file(variable) ||
           (variable->storage == IR_PARAMETER && variable->function == function &&
            !ir_type_is_variably_modified(variable->type));
}

/* Is it an operator or operand that may occur in an address? Other operators compute more than an
 * address. */
static bool is_operator(const ir_node *node, const ir_function *function) {
    switch (node->kind) {
    case IR_VARIABLE:
        return can_be_named(node->variable, function);
    case IR_CAST:
        return !ir_type_is_variably_modified(node->type);
    case IR_UNARY:
        return node->op == IR_OP_ADDRESS || node->op == IR_OP_DEREFERENCE ||
               node->op == IR_OP_MINUS;
    case IR_BINARY:
        return node->op == IR_OP_ADD || node->op == IR_OP_SUBTRACT || node->op == IR_OP_MULTIPLY;
    default:
        return node->kind == IR_NUMBER || node->kind == IR_INDEX || node->kind == IR_MEMBER;
    }
}

static bool is_place(const ir_node *node, const ir_function *function) {
    if (!node->type || node->type->is_volatile || node->type->is_atomic ||
        !is_operator(node, function))
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!is_place(node->children[i], function))
            return false;
    return true;
}

/* May a call do something that the body does not show? */
static bool is_unknown(const ir_function *function) {
    return function->body == NULL || function->is_variadic || function->has_errors ||
           function->has_other_attributes || function->linkage.is_weak ||
           function->linkage.is_renamed;
}

/* The address that the function returns, if it does nothing else; otherwise NULL. */
static const ir_node *returned_place(accessors *a, ir_function *function) {
    if (is_unknown(function) || a->functions[function->id] == BEGUN)
        return NULL;
    look_through(a, function);
    const ir_node *body = function->body;
    const ir_node *only = body->child_count == 1 ? body->children[0] : NULL;
    if (!only || only->kind != IR_RETURN || only->child_count != 1)
        return NULL;
    const ir_node *value = only->children[0];
    const ir_type *result = function->type->target;
    const bool decays = value->type && value->type->kind == IR_ARRAY;
    if (!result || result->kind != IR_POINTER || !result->target || result->target->size <= 0 ||
        !is_place(value, function) ||
        !(decays ? ir_type_equal(value->type->target, result->target)
                 : ir_type_equal(value->type, result)))
        return NULL;
    return value;
}

static bool has_volatile_type(const ir_node *node) {
    return node->type && (node->type->is_volatile || node->type->is_atomic);
}

/* Can the arguments replace the parameters? Each argument may then be evaluated once, several times
 * or not at all, so it must have no effect. */
static bool can_be_put_in(const ir_node *call, const ir_function *function) {
    if (call->child_count != function->parameter_count + 1)
        return false;
    for (unsigned i = 1; i < call->child_count; i++)
        if (ir_has_effect(call->children[i]) || ir_any(call->children[i], has_volatile_type) ||
            !ir_type_is_scalar(function->parameters[i - 1]->type))
            return false;
    return true;
}

static void stand_for(ir_node *node, ir_range range, unsigned flags) {
    node->range = range;
    node->flags |= flags;
    for (unsigned i = 0; i < node->child_count; i++)
        stand_for(node->children[i], range, flags);
}

static bool is_name_of_file(const ir_node *node) {
    return node->kind == IR_VARIABLE && is_of_file(node->variable);
}

static unsigned count_nodes(const ir_node *node) {
    unsigned count = 1;
    for (unsigned i = 0; i < node->child_count; i++)
        count += count_nodes(node->children[i]);
    return count;
}

static bool has_variable(const ir_unit *unit, const ir_function *caller, const char *name) {
    for (unsigned i = 0; i < unit->variable_count; i++)
        if (unit->variables[i]->function == caller && strcmp(unit->variables[i]->name, name) == 0)
            return true;
    return false;
}

/* Does the caller have a variable with the same name as a file-scope variable in the address? */
static bool hides_names(const ir_unit *unit, const ir_function *caller, const ir_node *place) {
    if (place->kind == IR_VARIABLE && is_of_file(place->variable) &&
        has_variable(unit, caller, place->variable->name))
        return true;
    for (unsigned i = 0; i < place->child_count; i++)
        if (hides_names(unit, caller, place->children[i]))
            return true;
    return false;
}

/* Is the accessor defined before the caller? Then all names in its address are declared there. */
static bool is_defined_before(const ir_function *function, const ir_function *caller) {
    return !function->is_in_main_file || !caller->is_in_main_file ||
           function->range.begin < caller->range.begin;
}

/* The address with the arguments substituted; the call itself if it does not call an accessor. */
static ir_node *place_of_call(accessors *a, const ir_function *caller, ir_node *call) {
    ir_function *function = ir_called_function(call);
    const ir_node *place = function ? returned_place(a, function) : NULL;
    if (!place || !is_defined_before(function, caller) || !can_be_put_in(call, function) ||
        hides_names(a->unit, caller, place))
        return call;
    ir_node *copy = ir_substitute(a->memory, place, function, &call->children[1]);
    if (count_nodes(copy) > MOST_NODES)
        return call;
    stand_for(copy, call->range,
              IR_FROM_MACRO | (ir_any(place, is_name_of_file) ? IR_FROM_CALL : 0));
    return copy;
}

/* Simplifies an access to an address that replaced a call: *&x becomes x, and (&x)->m becomes
 * x.m. */
static void simplify_address(ir_node *node) {
    assert(ir_is_address_of(node->children[0]));
    ir_node *object = node->children[0]->children[0];
    if (node->kind == IR_MEMBER) {
        node->flags &= ~(unsigned)IR_ARROW;
        node->children[0] = object;
        return;
    }
    const ir_range range = node->range;
    *node = *object;
    stand_for(node, range, 0);
}

/* ---- sums of pointers ------------------------------------------------------------------------ */

static bool is_sum_of_pointer(const ir_node *node) {
    return node->kind == IR_BINARY && (node->op == IR_OP_ADD || node->op == IR_OP_SUBTRACT) &&
           node->type && node->type->kind == IR_POINTER && node->type->target &&
           node->type->target->kind != IR_VOID && node->type->target->kind != IR_FUNCTION_TYPE &&
           node->children[0]->type && node->children[1]->type;
}

/* Converts the number to the width of an address. In a narrower type, a sum of subscripts could
 * overflow where the sums with the pointer do not. */
static ir_node *as_long(arena *memory, ir_node *number) {
    if (number->type->kind == IR_INTEGER && number->type->is_signed && number->type->size == 8)
        return number;
    ir_type *type = ARENA_NEW(memory, ir_type);
    ir_scalar_type(type, ir_scalar_named("long", 4));
    ir_node *cast = ir_new(memory, IR_CAST, type, 1);
    cast->children[0] = number;
    cast->range = number->range;
    cast->flags = IR_FROM_MACRO;
    return cast;
}

/* Splits a sum p + e - f + ... : returns p and stores e - f + ... in *subscript. */
static ir_node *split_sum(arena *memory, ir_node *sum, ir_node **subscript) {
    assert(is_sum_of_pointer(sum));
    const ir_type *left = sum->children[0]->type;
    const unsigned side = left->kind == IR_POINTER || left->kind == IR_ARRAY ? 0 : 1;
    ir_node *base = sum->children[side], *number = sum->children[1 - side];
    const bool is_less = sum->op == IR_OP_SUBTRACT;
    ir_node *before = NULL;
    if (is_sum_of_pointer(base))
        base = split_sum(memory, base, &before);
    *subscript = number;
    if (!before && !is_less)
        return base;
    ir_node *first = as_long(memory, before ? before : number);
    ir_node *whole = ir_new(memory, before ? IR_BINARY : IR_UNARY, first->type, before ? 2 : 1);
    whole->op = !before ? IR_OP_MINUS : sum->op;
    whole->children[0] = first;
    if (before)
        whole->children[1] = number;
    if (before && number->type->size == 8 && !number->type->is_signed)
        whole->type = number->type;
    whole->range = sum->range;
    whole->flags = IR_FROM_MACRO;
    *subscript = whole;
    return base;
}

static void become_element(arena *memory, ir_node *node, ir_node *base, ir_node *subscript) {
    assert(ir_is_expression(base) && ir_is_expression(subscript));
    node->kind = IR_INDEX;
    node->op = IR_OP_NONE;
    node->child_count = 2;
    node->children = ARENA_ARRAY(memory, ir_node *, 2);
    node->children[0] = base;
    node->children[1] = subscript;
}

/* Rewrites *(p + k) as p[k], and (p + k)->m as p[k].m. Several summands become one subscript,
 * because the analysis handles only one. */
static void simplify_sum(arena *memory, ir_node *node) {
    ir_node *sum = node->children[0], *subscript;
    ir_node *base = split_sum(memory, sum, &subscript);
    ir_node *element = node;
    if (node->kind == IR_MEMBER) {
        node->flags &= ~(unsigned)IR_ARROW;
        node->children[0] = element = ir_new(memory, IR_INDEX, sum->type->target, 2);
        element->range = sum->range;
    }
    element->flags |= sum->flags & (IR_FROM_MACRO | IR_FROM_CALL);
    become_element(memory, element, base, subscript);
}

/* Rewrites the access *a to an array a as a[0]. */
static void simplify_array(arena *memory, ir_node *node) {
    ir_type *type = ARENA_NEW(memory, ir_type);
    ir_scalar_type(type, ir_scalar_named("int", 3));
    ir_node *first = ir_new(memory, IR_NUMBER, type, 0);
    first->text = "0";
    first->range = node->range;
    first->flags = IR_FROM_MACRO | IR_HAS_VALUE;
    become_element(memory, node, node->children[0], first);
}

void ir_simplify_access(arena *memory, ir_node *node, bool is_replaced) {
    const ir_node *pointer = node->child_count ? node->children[0] : NULL;
    const bool is_arrow = node->kind == IR_MEMBER && (node->flags & IR_ARROW);
    const bool is_dereference = node->kind == IR_UNARY && node->op == IR_OP_DEREFERENCE;
    if (!is_arrow && !is_dereference)
        return;
    if (is_dereference && pointer->type && pointer->type->kind == IR_ARRAY)
        simplify_array(memory, node);
    else if (is_sum_of_pointer(pointer))
        simplify_sum(memory, node);
    else if (is_replaced && pointer->kind == IR_UNARY && pointer->op == IR_OP_ADDRESS)
        simplify_address(node);
}

static void visit(accessors *a, const ir_function *function, ir_node *node) {
    bool has_changed = false;
    for (unsigned i = 0; i < node->child_count; i++) {
        ir_node *child = node->children[i];
        visit(a, function, child);
        if (child->kind == IR_CALL)
            node->children[i] = place_of_call(a, function, child);
        has_changed |= node->children[i] != child;
    }
    ir_simplify_access(a->memory, node, has_changed);
}

static void look_through(accessors *a, ir_function *function) {
    assert(function->id < a->unit->function_count);
    if (a->functions[function->id] != UNSEEN || !function->body)
        return;
    a->functions[function->id] = BEGUN;
    visit(a, function, function->body);
    a->functions[function->id] = DONE;
}

void ir_look_through_accessors(ir_unit *unit) {
    accessors a = {.memory = unit->arena, .unit = unit};
    a.functions = ARENA_ARRAY(unit->arena, progress, unit->function_count + 1u);
    for (unsigned i = 0; i < unit->function_count; i++) {
        assert(unit->functions[i]->id == i);
        look_through(&a, unit->functions[i]);
    }
}
