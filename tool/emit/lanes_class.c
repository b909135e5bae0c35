/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Which variables are the same for all lanes, and what becomes of the others. */
#include "emit/lifter.h"
#include "plan/lookup.h"

bool lane_is_own(const lifter *l, const ir_variable *variable) {
    const loop_facts *facts = l->loop->facts;
    if (l->function)
        return variable->function == l->function;
    if (variable == facts->counted.counter)
        return true;
    return is_declared_in(facts, variable);
}

bool lane_is_uniform(const lifter *l, const ir_node *node) {
    switch (node->kind) {
    case IR_VARIABLE:
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

bool lane_mentions_lifted(const lifter *l, const ir_node *node) {
    if (node->kind == IR_VARIABLE && l->class_of[node->variable->id] == LANE_LIFTED)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (lane_mentions_lifted(l, node->children[i]))
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

/** The lifted variable whose element or value this is, by subscripts that are allowed, or NULL. */
static const ir_variable *lifted_root(const lifter *l, const ir_node *node,
                                      bool (*allows)(const lifter *l, const ir_node *subscript)) {
    for (;;) {
        if (node->kind == IR_VARIABLE)
            return l->class_of[node->variable->id] == LANE_LIFTED ? node->variable : NULL;
        if (node->kind == IR_INDEX && allows(l, node->children[1]))
            node = node->children[0];
        else if (node->kind == IR_UNARY &&
                 (node->op == IR_OP_DEREFERENCE || node->op == IR_OP_ADDRESS))
            node = node->children[0];
        else
            return NULL;
    }
}

const ir_variable *lane_lifted_root(const lifter *l, const ir_node *node) {
    return lifted_root(l, node, lane_is_uniform);
}

static bool is_of_a_lane(const lifter *l, const ir_node *subscript) {
    return lane_is_plain(subscript) && !lane_mentions_lifted(l, subscript);
}

const ir_variable *lane_lifted_element(const lifter *l, const ir_node *node) {
    return lifted_root(l, node, is_of_a_lane);
}

bool lane_has_whole_lifted(const lifter *l, const ir_node *node) {
    if (lane_is_real(node->type) && lane_lifted_element(l, node))
        return false;
    if (node->kind == IR_VARIABLE && l->class_of[node->variable->id] == LANE_LIFTED)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (lane_has_whole_lifted(l, node->children[i]))
            return true;
    return false;
}

/** What becomes of a variable of that type, at first. */
static lane_class first_class(lifter *l, const ir_variable *variable, const ir_node *node) {
    const ir_type *type = variable->type;
    const ir_type *innermost = ir_type_innermost(type);
    if (type->is_volatile || type->is_atomic || innermost->is_volatile || innermost->is_atomic ||
        variable->storage == IR_STATIC_LOCAL || variable->storage == IR_THREAD_LOCAL)
        lane_problem(l, NO_LANES_STORAGE, node);
    if (lane_is_real(innermost) && type->size > 0)
        return LANE_LIFTED;
    if (type->kind != IR_INTEGER && type->kind != IR_BOOLEAN && type->kind != IR_POINTER)
        lane_problem(l, NO_LANES_VARIABLE_TYPE, node);
    return LANE_UNIFORM;
}

/** Is it 1 or 0: a comparison, or several with && || and !? */
static bool is_truth(const ir_node *node) {
    return (node->kind == IR_UNARY && node->op == IR_OP_NOT) ||
           (node->kind == IR_BINARY && node->op >= IR_OP_LESS && node->op <= IR_OP_OR);
}

static bool find_mask(ir_node *node, void *context) {
    lifter *l = context;
    if (node->kind == IR_DECLARATOR && node->child_count > 0 && lane_is_own(l, node->variable) &&
        node->variable->type->kind == IR_INTEGER && node->variable->type->is_const &&
        is_truth(node->children[0]) && lane_mentions_lifted(l, node->children[0]))
        l->class_of[node->variable->id] = LANE_MASK;
    return true;
}

typedef struct spreading {
    lifter *l;
    bool has_changed;
} spreading;

static void spread(spreading *s, const ir_variable *variable, const ir_node *value) {
    lifter *l = s->l;
    if (!lane_is_own(l, variable) || l->class_of[variable->id] != LANE_UNIFORM)
        return;
    if (variable->type->kind == IR_POINTER && lane_mentions_lifted(l, value))
        lane_problem(l, NO_LANES_ARRAY_AS_POINTER, value);
    if (lane_is_uniform(l, value))
        return;
    if (variable->storage == IR_PARAMETER && l->function)
        lane_problem(l, NO_LANES_PARAMETER, value);
    l->class_of[variable->id] = LANE_VARYING;
    s->has_changed = true;
}

/** Does the lane decide whether this part of the node is executed, or how often? */
static bool is_divided(const lifter *l, const ir_node *node, const ir_node *part) {
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

/** The part of the scope outside of which the variable's value is of no use: what holds its
 *  declaration, or the outermost `for` around the write, where all that mentions the variable lies
 *  in such ones that give it its first value. */
static const ir_node *life_of(const lifter *l, const ir_node *write, const ir_variable *variable) {
    const bool is_counter = lane_is_counter_only(l->scope, variable);
    const ir_node *life = l->scope;
    for (const ir_node *at = write; at && at != l->scope; at = at->parent) {
        if (ir_declarator_in(at, variable))
            return at;
        if (is_counter && at->kind == IR_FOR && lane_begins_with(at, variable))
            life = at;
    }
    return life;
}

/** Do only some lanes make this write of the variable? Jumps out of what stands around it are not
 *  written for vectors at all. */
static bool is_of_some_lanes(const lifter *l, const ir_node *write, const ir_variable *variable) {
    const ir_node *const life = life_of(l, write, variable);
    for (const ir_node *at = write; at != life && at->parent; at = at->parent)
        if (is_divided(l, at->parent, at))
            return true;
    return false;
}

/** An own integer or pointer is the same for all lanes only if all of them make every write of it.
 */
static void spread_of_some_lanes(spreading *s, const ir_node *node) {
    lifter *l = s->l;
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

static bool spread_node(ir_node *node, void *context) {
    spread_of_some_lanes(context, node);
    if (node->kind == IR_ASSIGN && node->children[0]->kind == IR_VARIABLE)
        spread(context, node->children[0]->variable, node->children[1]);
    if (node->kind == IR_DECLARATOR && node->child_count > 0)
        spread(context, node->variable, node->children[0]);
    return true;
}

typedef struct listing {
    lifter *l;
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
        variable == it->l->loop->facts->counted.counter && !it->l->function
            ? LANE_VARYING
            : first_class(it->l, variable, node);
    return true;
}

/** Parameters have theirs already. */
void lane_classify(lifter *l) {
    listing list = {l, ARENA_ARRAY(l->loop->arena, bool, l->loop->unit->variable_count + 1)};
    spreading s = {.l = l, .has_changed = true};
    ir_walk((ir_node *)l->scope, list_node, &list);
    ir_walk((ir_node *)l->scope, find_mask, l);
    while (s.has_changed) {
        s.has_changed = false;
        ir_walk((ir_node *)l->scope, spread_node, &s);
    }
}
