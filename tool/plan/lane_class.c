/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/lane_class.h"

#include <assert.h>

#include "plan/lanes.h"
#include "plan/lookup.h"

static bool has_place(ir_range range) {
    return range.begin < range.end;
}

void lane_note_place(lane_scope *l, const ir_node *node) {
    if (has_place(node->range))
        l->place = node->range;
}

void lane_problem(const lane_scope *l, lane_reason why, const ir_node *node) {
    assert(why != LANES_WRITTEN && why < LANE_REASON_COUNT);
    lanes_outcome *outcome = l->outcome;
    if (outcome->why == LANES_WRITTEN)
        *outcome = (lanes_outcome){why, node && has_place(node->range) ? node->range : l->place};
}

/* ---- queries on expressions ---------------------------------------------------------------- */

bool lane_is_real(const ir_type *type) {
    return type && type->kind == IR_FLOATING && (type->size == 8 || type->size == 4);
}

static bool is_number(const ir_type *type) {
    return type && (lane_is_real(type) || type->kind == IR_INTEGER || type->kind == IR_BOOLEAN);
}

const ir_type *lane_common(const ir_type *left, const ir_type *right) {
    if (!is_number(left) || !is_number(right))
        return NULL;
    if (!lane_is_real(left))
        return lane_is_real(right) ? right : NULL;
    return lane_is_real(right) && right->size > left->size ? right : left;
}

bool lane_is_own(const lane_scope *l, const ir_variable *variable) {
    const loop_facts *facts = l->plan->facts;
    if (l->function)
        return variable->function == l->function;
    if (variable == facts->counted.counter)
        return true;
    return is_declared_in(facts, variable);
}

bool lane_is_uniform(const lane_scope *l, const ir_node *node) {
    switch (node->kind) {
    case IR_VARIABLE:
        assert(node->variable->id < l->plan->unit->variable_count);
        return l->class_of[node->variable->id] == LANE_UNIFORM;
    case IR_CALL:
    case IR_ASSIGN:
    case IR_OPAQUE:
    case IR_STRING:
    case IR_FUNCTION:
    case IR_INITIALIZERS:
        return false;
    case IR_UNARY:
        if (ir_is_increment(node))
            return false;
        break;
    case IR_SIZEOF:
        return true;
    default:
        break;
    }
    for (unsigned i = 0; i < node->child_count; i++)
        if (!lane_is_uniform(l, node->children[i]))
            return false;
    return true;
}

bool lane_mentions_vector(const lane_scope *l, const ir_node *node) {
    if (node->kind == IR_VARIABLE && l->class_of[node->variable->id] == LANE_VECTOR)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (lane_mentions_vector(l, node->children[i]))
            return true;
    return false;
}

bool lane_is_plain(const ir_node *node) {
    if (node->kind == IR_CALL || node->kind == IR_ASSIGN || node->kind == IR_OPAQUE ||
        node->kind == IR_STRING || node->kind == IR_INITIALIZERS ||
        (node->kind == IR_UNARY && node->op >= IR_OP_PRE_INCREMENT))
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!lane_is_plain(node->children[i]))
            return false;
    return true;
}

/** Returns the LANE_VECTOR variable that the node names, as a whole or by an element. NULL if there
 * is none, or if `allows` rejects a subscript. */
static const ir_variable *vector_root(const lane_scope *l, const ir_node *node,
                                      bool (*allows)(const lane_scope *l,
                                                     const ir_node *subscript)) {
    for (;;) {
        if (node->kind == IR_VARIABLE)
            return l->class_of[node->variable->id] == LANE_VECTOR ? node->variable : NULL;
        if (node->kind == IR_INDEX && allows(l, node->children[1]))
            node = node->children[0];
        else if (node->kind == IR_UNARY &&
                 (node->op == IR_OP_DEREFERENCE || node->op == IR_OP_ADDRESS))
            node = node->children[0];
        else
            return NULL;
    }
}

const ir_variable *lane_vector_root(const lane_scope *l, const ir_node *node) {
    return vector_root(l, node, lane_is_uniform);
}

static bool is_of_a_lane(const lane_scope *l, const ir_node *subscript) {
    return lane_is_plain(subscript) && !lane_mentions_vector(l, subscript);
}

const ir_variable *lane_vector_element(const lane_scope *l, const ir_node *node) {
    return vector_root(l, node, is_of_a_lane);
}

bool lane_has_whole_vector(const lane_scope *l, const ir_node *node) {
    if (lane_is_real(node->type) && lane_vector_element(l, node))
        return false;
    if (node->kind == IR_VARIABLE && l->class_of[node->variable->id] == LANE_VECTOR)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (lane_has_whole_vector(l, node->children[i]))
            return true;
    return false;
}

lane_reason lane_effect_of(const ir_node *node) {
    if (node->kind == IR_CALL)
        return NO_LANES_CALL;
    for (unsigned i = 0; i < node->child_count; i++)
        if (lane_effect_of(node->children[i]) == NO_LANES_CALL)
            return NO_LANES_CALL;
    return NO_LANES_OPERAND_EFFECT;
}

bool lane_has_operator(ir_operator op) {
    return op >= IR_OP_ADD && op <= IR_OP_DIVIDE;
}

bool lane_is_safe(const lane_scope *l, const ir_node *node) {
    if (lane_is_real(node->type) && lane_vector_root(l, node))
        return true;
    if (node->kind == IR_INDEX || node->kind == IR_CALL || node->kind == IR_ASSIGN ||
        node->kind == IR_OPAQUE || (node->kind == IR_MEMBER && node->flags & IR_ARROW) ||
        (node->kind == IR_UNARY &&
         (node->op == IR_OP_DEREFERENCE || node->op >= IR_OP_PRE_INCREMENT)))
        return false;
    /* the cast is undefined if the value is outside of the integer's range */
    if (node->kind == IR_CAST && !lane_is_real(node->type) && lane_is_real(node->children[0]->type))
        return false;
    const bool is_arithmetic =
        (node->kind == IR_BINARY && node->op <= IR_OP_BIT_XOR) ||
        (node->kind == IR_UNARY && node->op == IR_OP_MINUS && node->children[0]->kind != IR_NUMBER);
    if (is_arithmetic && !lane_is_real(node->type) && !(node->flags & IR_HAS_VALUE))
        return false; /* integer arithmetic may overflow, or divide by 0 */
    for (unsigned i = 0; i < node->child_count; i++)
        if (!lane_is_safe(l, node->children[i]))
            return false;
    return true;
}

bool lane_is_integer_choice(const lane_scope *l, const ir_node *node) {
    assert(ir_is_expression(node));
    return node->kind == IR_CONDITIONAL && lane_mentions_vector(l, node->children[0]) &&
           ir_type_equal(node->children[1]->type, node->type) &&
           ir_type_equal(node->children[2]->type, node->type);
}

/* ---- classes --------------------------------------------------------------------------------- */

/** Is the variable declared in an update statement, and used only there? */
static bool is_of_updates(const lane_scope *l, const ir_node *node) {
    return !l->function && node->kind == IR_DECLARATOR && lane_updating(l, node);
}

/** The class of a variable before classes are propagated. */
static lane_class first_class(lane_scope *l, const ir_variable *variable, const ir_node *node) {
    const ir_type *type = variable->type;
    const ir_type *innermost = ir_type_innermost(type);
    if (type->is_volatile || type->is_atomic || innermost->is_volatile || innermost->is_atomic ||
        variable->storage == IR_STATIC_LOCAL || variable->storage == IR_THREAD_LOCAL)
        lane_problem(l, NO_LANES_STORAGE, node);
    if (is_of_updates(l, node))
        return LANE_LOCAL;
    if (lane_is_real(innermost) && type->size > 0)
        return LANE_VECTOR;
    if (type->kind != IR_INTEGER && type->kind != IR_BOOLEAN && type->kind != IR_POINTER)
        lane_problem(l, NO_LANES_VARIABLE_TYPE, node);
    return LANE_UNIFORM;
}

/** Is the node's value 0 or 1: a comparison, or several joined by &&, || and !? */
static bool is_truth(const ir_node *node) {
    return (node->kind == IR_UNARY && node->op == IR_OP_NOT) ||
           (node->kind == IR_BINARY && node->op >= IR_OP_LESS && node->op <= IR_OP_OR);
}

static bool find_mask(ir_node *node, void *context) {
    lane_scope *l = context;
    if (node->kind == IR_DECLARATOR && node->child_count > 0 && lane_is_own(l, node->variable) &&
        l->class_of[node->variable->id] == LANE_UNIFORM &&
        node->variable->type->kind == IR_INTEGER && node->variable->type->is_const &&
        is_truth(node->children[0]) && lane_mentions_vector(l, node->children[0]))
        l->class_of[node->variable->id] = LANE_MASK;
    return true;
}

typedef struct propagation {
    lane_scope *l;
    bool has_changed;
} propagation;

static void propagate(propagation *s, const ir_variable *variable, const ir_node *value) {
    lane_scope *l = s->l;
    if (!lane_is_own(l, variable) || l->class_of[variable->id] != LANE_UNIFORM)
        return;
    if (variable->type->kind == IR_POINTER && lane_mentions_vector(l, value))
        lane_problem(l, NO_LANES_ARRAY_AS_POINTER, value);
    if (lane_is_uniform(l, value))
        return;
    if (variable->storage == IR_PARAMETER && l->function)
        lane_problem(l, NO_LANES_PARAMETER, value);
    l->class_of[variable->id] = LANE_VARYING;
    s->has_changed = true;
}

/** Is this part of the node executed under a condition, or a number of times, that differs between
 *  lanes? */
static bool is_divergent(const lane_scope *l, const ir_node *node, const ir_node *part) {
    switch (node->kind) {
    case IR_IF:
    case IR_CONDITIONAL:
    case IR_SWITCH:
    case IR_WHILE:
        return part != node->children[0] && !lane_is_uniform(l, node->children[0]);
    case IR_DO:
        return !lane_is_uniform(l, node->children[1]);
    case IR_FOR:
        return part != node->children[0] && node->children[1]->kind != IR_EMPTY &&
               !lane_is_uniform(l, node->children[1]);
    case IR_BINARY:
        return (node->op == IR_OP_AND || node->op == IR_OP_OR) && part == node->children[1] &&
               !lane_is_uniform(l, node->children[0]);
    default:
        return false;
    }
}

/** Returns the part of the scope that contains all uses of the written value. This is the block
 * with the variable's declaration. If all uses are in loops that initialise the variable, it is
 * the outermost such `for` around the write. Otherwise it is the whole body. */
static const ir_node *life_of(const lane_scope *l, const ir_node *write,
                              const ir_variable *variable) {
    const bool is_counter = lane_is_counter_only(l->body, variable);
    const ir_node *life = l->body;
    for (const ir_node *at = write; at && at != l->body; at = at->parent) {
        if (ir_declarator_in(at, variable))
            return at;
        if (is_counter && at->kind == IR_FOR && lane_begins_with(at, variable))
            life = at;
    }
    return life;
}

/** Do only some lanes execute this write of the variable? Jumps out of enclosing statements need
 *  not be considered, because they have no vector form. */
static bool is_of_some_lanes(const lane_scope *l, const ir_node *write,
                             const ir_variable *variable) {
    const ir_node *const life = life_of(l, write, variable);
    for (const ir_node *at = write; at != life && at->parent; at = at->parent)
        if (is_divergent(l, at->parent, at))
            return true;
    return false;
}

/** If only some lanes execute this write of a uniform integer or pointer, makes the variable
 * LANE_VARYING. */
static void propagate_divergent_write(propagation *s, const ir_node *node) {
    lane_scope *l = s->l;
    const ir_node *target = ir_child(node, 0);
    const bool is_assignment = node->kind == IR_ASSIGN || ir_is_increment(node);
    if (!is_assignment || target->kind != IR_VARIABLE || !lane_is_own(l, target->variable) ||
        l->class_of[target->variable->id] != LANE_UNIFORM ||
        !is_of_some_lanes(l, node, target->variable))
        return;
    if (target->variable->storage == IR_PARAMETER && l->function)
        lane_problem(l, NO_LANES_PARAMETER, node);
    l->class_of[target->variable->id] = LANE_VARYING;
    s->has_changed = true;
}

/** If an update statement writes a uniform variable that is not a loop counter, makes it
 * LANE_VARYING. */
static void propagate_update_write(propagation *s, const ir_node *node) {
    lane_scope *l = s->l;
    const ir_node *target = ir_child(node, 0);
    if ((node->kind != IR_ASSIGN && !ir_is_increment(node)) || target->kind != IR_VARIABLE ||
        l->function || l->class_of[target->variable->id] != LANE_UNIFORM ||
        !lane_is_own(l, target->variable) || !lane_updating(l, node) ||
        lane_is_counter_only(l->body, target->variable))
        return;
    l->class_of[target->variable->id] = LANE_VARYING;
    s->has_changed = true;
}

static bool propagate_node(ir_node *node, void *context) {
    propagate_update_write(context, node);
    propagate_divergent_write(context, node);
    if (node->kind == IR_ASSIGN && node->children[0]->kind == IR_VARIABLE)
        propagate(context, node->children[0]->variable, node->children[1]);
    if (node->kind == IR_DECLARATOR && node->child_count > 0)
        propagate(context, node->variable, node->children[0]);
    return true;
}

typedef struct listing {
    lane_scope *l;
    bool *is_listed;
} listing;

static bool list_node(ir_node *node, void *context) {
    const listing *it = context;
    const ir_variable *variable = node->variable;
    const bool is_variable = node->kind == IR_VARIABLE || node->kind == IR_DECLARATOR;
    if (!is_variable || it->is_listed[variable->id] || !lane_is_own(it->l, variable) ||
        variable->storage == IR_PARAMETER)
        return true;
    it->is_listed[variable->id] = true;
    it->l->class_of[variable->id] =
        variable == it->l->plan->facts->counted.counter && !it->l->function
            ? LANE_VARYING
            : first_class(it->l, variable, node);
    return true;
}

void lane_classify(lane_scope *l) {
    listing list = {l, ARENA_ARRAY(l->plan->arena, bool, l->plan->unit->variable_count + 1)};
    propagation s = {.l = l, .has_changed = true};
    ir_walk((ir_node *)l->body, list_node, &list);
    ir_walk((ir_node *)l->body, find_mask, l);
    while (s.has_changed) {
        s.has_changed = false;
        ir_walk((ir_node *)l->body, propagate_node, &s);
    }
}
