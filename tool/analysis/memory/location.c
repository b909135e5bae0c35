/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/memory/location.h"

#include <assert.h>

#include "analysis/base/expression.h"
#include "analysis/base/library.h"

enum { STEP_LIMIT = 8, LOOK_THROUGH_LIMIT = 8 };

/* The constant data of one call of location_of. */
typedef struct query {
    variable_facts *facts;
    const ir_node *scope;
} query;

static location lvalue_location(const query *q, const ir_node *node, unsigned depth);
static location pointed_location(const query *q, const ir_node *node, unsigned depth);

static void add_step(location *l, const ir_field *field, const ir_record *record,
                     const ir_node *subscript) {
    assert(l->step_count <= STEP_LIMIT && !(field && subscript));
    if (l->is_inexact)
        return;
    if (l->step_count == STEP_LIMIT) {
        l->is_inexact = true;
        return;
    }
    l->steps[l->step_count++] = (location_step){field, record, subscript};
}

/* Arithmetic on a pointer to a single object, as in &v[0].x + k, is undefined in C. Programs and
 * compilers nevertheless let the result be anywhere in the enclosing object. */
static void leave_single_object(location *l) {
    l->step_count = 0;
    l->is_inexact = true;
}

static bool is_zero(const ir_node *node) {
    int64_t value;
    return expression_constant(node, &value) && value == 0;
}

static location unknown_location(void) {
    return (location){.is_inexact = true};
}

static location member_location(const query *q, const ir_node *node, unsigned depth) {
    const ir_node *child = node->children[0];
    bool is_arrow = node->flags & IR_ARROW;
    location l = is_arrow ? pointed_location(q, child, depth) : lvalue_location(q, child, depth);
    const ir_type *owner = child->type;
    if (is_arrow && owner)
        owner = owner->target;
    const ir_record *record = owner ? owner->record : NULL;
    if (record && record->is_union) {
        l.has_union = true;
        l.is_inexact = true;
    }
    if (node->field && node->field->is_bit_field)
        l.has_bit_field = true;
    add_step(&l, node->field, record, NULL);
    return l;
}

/* The location of (*__ctype_b_loc())[c] or *__ctype_b_loc(). It belongs to the C library and is in
 * no object of the program. */
static location locale_location(const ir_node *table) {
    return (location){.is_of_locale = true, .is_inexact = true, .base = table};
}

static bool is_locale_table(const ir_node *node) {
    return node->kind == IR_UNARY && node->op == IR_OP_DEREFERENCE &&
           library_is_locale_table(node->children[0]);
}

static location lvalue_location(const query *q, const ir_node *node, unsigned depth) {
    location l;
    if (is_locale_table(node)) {
        l = locale_location(node);
        l.type = node->type;
        return l;
    }
    switch (node->kind) {
    case IR_VARIABLE:
        l = (location){.object = node->variable, .base = node};
        break;
    case IR_INDEX:
        if (node->children[0]->type && node->children[0]->type->kind == IR_ARRAY) {
            l = lvalue_location(q, node->children[0], depth);
            add_step(&l, NULL, NULL, node->children[1]);
        } else {
            /* p[k] is the target of p, moved by k elements */
            l = pointed_location(q, node->children[0], depth);
            if (l.step_count && !l.steps[l.step_count - 1].field && !l.is_inexact)
                l.steps[l.step_count - 1].subscript =
                    l.steps[l.step_count - 1].subscript ? NULL : node->children[1];
            else if (!is_zero(node->children[1]))
                leave_single_object(&l);
        }
        break;
    case IR_MEMBER:
        l = member_location(q, node, depth);
        break;
    case IR_UNARY:
        if (node->op == IR_OP_DEREFERENCE)
            l = pointed_location(q, node->children[0], depth);
        else
            l = unknown_location();
        break;
    case IR_STRING:
        l = (location){.is_string = true, .is_inexact = true, .base = node};
        break;
    default:
        l = unknown_location();
    }
    l.type = node->type;
    return l;
}

/* The target of a pointer that is read from memory or from a variable. The pointer is the
 * location's base, and step 0 is the subscript that may follow. */
static location pointer_base(const ir_node *node) {
    location l = {.pointer = node, .base = node};
    l.steps[0] = (location_step){NULL, NULL, NULL};
    l.step_count = 1;
    return l;
}

static bool same_pointee(const ir_type *a, const ir_type *b) {
    return a && b && a->target && b->target && ir_type_equal(a->target, b->target);
}

/* The operand of pointer + n, n + pointer or pointer - n that is the pointer or array. */
static unsigned pointer_side(const ir_node *sum) {
    const ir_type *left = sum->children[0]->type;
    return left && (left->kind == IR_POINTER || left->kind == IR_ARRAY) ? 0 : 1;
}

/* Does the integer expression contain no assignment and no opaque node? Calls are permitted. */
static bool is_distance(const ir_node *node) {
    if (node->kind == IR_OPAQUE || expression_written(node))
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!is_distance(node->children[i]))
            return false;
    return true;
}

/* Is it an lvalue such as base[n] or base[n].f, in which only n calls functions? */
static bool is_moved_place(const ir_node *place) {
    const ir_node *child = ir_child(place, 0);
    if (place->kind == IR_MEMBER && !(place->flags & IR_ARROW))
        return is_moved_place(child);
    if (place->kind != IR_INDEX)
        return expression_is_plain(place);
    return is_distance(place->children[1]) &&
           (ir_is_array(child) ? is_moved_place(child) : expression_is_plain(child));
}

/* Is the pointer base + n, base - n, &base[n], or an array base[n], in which only n calls
 * functions? It points into what base points into, whatever the calls return. */
static bool is_moved_by_call(const ir_node *value) {
    if (value->kind == IR_UNARY && value->op == IR_OP_ADDRESS)
        return is_moved_place(value->children[0]);
    if (value->kind != IR_BINARY || (value->op != IR_OP_ADD && value->op != IR_OP_SUBTRACT))
        return ir_is_array(value) && is_moved_place(value);
    const unsigned side = pointer_side(value);
    return expression_is_plain(value->children[side]) && is_distance(value->children[1 - side]);
}

/* Does the pointer's definition show what it points into? It must contain no call and no
 * assignment. For the analysis of a loop, calls may compute distances (is_moved_by_call). */
static bool is_followed(const query *q, const ir_node *value) {
    return value->kind != IR_INITIALIZERS &&
           (expression_is_plain(value) || (q->scope && is_moved_by_call(value)));
}

static const ir_node *without_pointer_casts(const ir_node *value) {
    while (value->kind == IR_CAST && value->children[0]->type &&
           value->children[0]->type->kind == IR_POINTER)
        value = value->children[0];
    return value;
}

/* Is the value the result of a call, as in f(...) or (double *)f(...)? It is then a separate
 * pointer with an unknown target. */
static bool is_result(const ir_node *value) {
    return without_pointer_casts(value)->kind == IR_CALL;
}

/* Is it a cast from a pointer to another type? Casts of void pointers, and of null, are not. */
static bool is_punning(const ir_node *node) {
    const ir_type *from = node->kind == IR_CAST ? node->children[0]->type : NULL;
    return from && (from->kind == IR_POINTER || from->kind == IR_ARRAY) && from->target &&
           from->target->kind != IR_VOID && !same_pointee(node->type, from);
}

/* Is the value a choice between pointers, as in flag ? a : b or (flag ? a : b) + n? A pointer that
 * is given such a value before the loop `scope` is a separate pointer with an unknown target.
 * Objects to which the choices point escape (variable_escapes), so it may point into them. */
static bool is_choice_before(const query *q, const ir_node *value, const ir_node *place) {
    if (!q->scope || ir_contains(q->scope, place) || ir_any(value, is_punning))
        return false;
    value = without_pointer_casts(value);
    while (value->kind == IR_BINARY && (value->op == IR_OP_ADD || value->op == IR_OP_SUBTRACT))
        value = without_pointer_casts(value->children[pointer_side(value)]);
    return value->kind == IR_CONDITIONAL;
}

/* The location of pointer + n, n + pointer or pointer - n. */
static location moved_location(const query *q, const ir_node *node, unsigned depth) {
    assert(node->kind == IR_BINARY && (node->op == IR_OP_ADD || node->op == IR_OP_SUBTRACT));
    const unsigned side = pointer_side(node);
    location l = pointed_location(q, node->children[side], depth);
    if (l.step_count && !l.steps[l.step_count - 1].field)
        l.steps[l.step_count - 1].subscript = NULL;
    else if (!is_zero(node->children[1 - side]))
        leave_single_object(&l);
    return l;
}

static location cast_location(const query *q, const ir_node *node, unsigned depth) {
    assert(node->kind == IR_CAST);
    const ir_node *operand = node->children[0];
    if (!operand->type || (operand->type->kind != IR_POINTER && operand->type->kind != IR_ARRAY))
        return unknown_location();
    location l = pointed_location(q, operand, depth);
    if (!same_pointee(node->type, operand->type)) {
        l.is_inexact = true;
        l.is_punned = true;
    }
    return l;
}

static void move_by_unknown(location *l) {
    if (l->step_count && !l->steps[l->step_count - 1].field)
        l->steps[l->step_count - 1].subscript = NULL;
    else
        leave_single_object(l);
}

static location variable_location(const query *q, const ir_node *node, unsigned depth) {
    assert(node->kind == IR_VARIABLE && depth <= LOOK_THROUGH_LIMIT);
    const ir_node *value = variable_single_definition(q->facts, node->variable);
    const ir_node *start = value ? NULL : variable_walk_start(q->facts, node->variable, q->scope);
    if (start && is_followed(q, start) && depth < LOOK_THROUGH_LIMIT) {
        location l = pointed_location(q, start, depth + 1);
        move_by_unknown(&l);
        return l;
    }
    const ir_node *array = value ? NULL : variable_walked_array(q->facts, node->variable);
    if (array)
        return pointed_location(q, array, depth);
    if (!value)
        return pointer_base(node);
    /* variable_escapes relies on this: a pointer with one definition is either replaced by it or
     * unknown, unless the definition is a call or a choice */
    const ir_node *place = variable_fact_of(q->facts, node->variable)->definition_place;
    if (is_choice_before(q, value, place))
        return pointer_base(node);
    if (depth >= LOOK_THROUGH_LIMIT || !is_followed(q, value))
        return is_result(value) ? pointer_base(node) : unknown_location();
    location l = pointed_location(q, value, depth + 1);
    if (q->scope && !ir_contains(q->scope, place))
        l.base = node;
    return l;
}

static location pointed_location(const query *q, const ir_node *node, unsigned depth) {
    if (is_locale_table(node))
        return locale_location(node);
    if (node->type && node->type->kind == IR_ARRAY) {
        location l = lvalue_location(q, node, depth);
        add_step(&l, NULL, NULL, NULL);
        return l;
    }
    switch (node->kind) {
    case IR_UNARY:
        if (node->op == IR_OP_ADDRESS)
            return lvalue_location(q, node->children[0], depth);
        /* *p is p[0] */
        return node->op == IR_OP_DEREFERENCE ? pointer_base(node) : unknown_location();
    case IR_BINARY:
        return node->op == IR_OP_ADD || node->op == IR_OP_SUBTRACT ? moved_location(q, node, depth)
                                                                   : unknown_location();
    case IR_CAST:
        return cast_location(q, node, depth);
    case IR_STRING:
        return (location){.is_string = true, .is_inexact = true, .base = node};
    case IR_VARIABLE:
        return variable_location(q, node, depth);
    case IR_MEMBER:
    case IR_INDEX:
        return pointer_base(node);
    default:
        return unknown_location();
    }
}

location location_of(variable_facts *facts, const ir_node *lvalue, const ir_node *scope) {
    query q = {facts, scope};
    return lvalue_location(&q, lvalue, 0);
}
