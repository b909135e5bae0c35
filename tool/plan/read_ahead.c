/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Before the first iteration, the generated text evaluates bases of arrays, first and last rows,
 * and keys. These must be expressions that the loop evaluates anyway if it iterates. If its body is
 *
 *     if (s) s->b[k[t]] += 1;
 *
 * then `s->b` may not be read ahead. An expression can fail if it reads through a pointer or
 * divides; each such part must occur in the loop's header, or in its body on a path that every
 * first iteration takes.
 */
#include "plan/read_ahead.h"

#include <assert.h>

#include "analysis/base/counted.h"
#include "ir/ir_syntax.h"

/* ---- code that is always executed ----------------------------------------------------------- */

typedef struct search {
    const loop_facts *facts;
    const ir_node *wanted;
    const ir_variable *parameter; /* in a called function: the parameter by which it gets the
                                   * structure. The search is then for any member reached by this
                                   * pointer, instead of `wanted` */
    bool is_found;
    bool may_have_left; /* a jump may skip the following code */
} search;

static void visit(search *s, const ir_node *node);

/** Sets *value to the counter's initial value. Returns false if it is not constant. */
static bool starts_with_constant(const ir_node *start, const ir_variable *counter, int64_t *value) {
    const ir_node *first = NULL;
    if (start->kind == IR_DECLARATION && start->child_count == 1 &&
        start->children[0]->variable == counter)
        first = ir_child(start->children[0], 0);
    else if (start->kind == IR_ASSIGN && start->op == IR_OP_NONE &&
             start->children[0]->kind == IR_VARIABLE && start->children[0]->variable == counter)
        first = start->children[1];
    if (!first || !(first->flags & IR_HAS_VALUE))
        return false;
    *value = first->value;
    return true;
}

/** Is the body executed at least once, as in for (c = 0; c < 3; ...)? */
static bool iterates(const ir_node *loop) {
    assert(loop->kind == IR_FOR);
    const ir_node *condition = ir_child(loop, 1);
    int64_t first;
    if (condition->kind != IR_BINARY || condition->children[0]->kind != IR_VARIABLE ||
        !(condition->children[1]->flags & IR_HAS_VALUE) ||
        !starts_with_constant(ir_child(loop, 0), condition->children[0]->variable, &first))
        return false;
    const int64_t bound = condition->children[1]->value;
    switch (condition->op) {
    case IR_OP_LESS:
        return first >= 0 && first < bound;
    case IR_OP_LESS_EQUAL:
        return first >= 0 && first <= bound;
    case IR_OP_GREATER:
        return bound >= 0 && first > bound;
    case IR_OP_GREATER_EQUAL:
        return bound >= 0 && first >= bound;
    default:
        return false;
    }
}

static void visit_inner_loop(search *s, const ir_node *loop) {
    const bool may_have_left = s->may_have_left;
    if (loop->kind == IR_FOR) {
        visit(s, ir_child(loop, 0));
        visit(s, ir_child(loop, 1));
        if (iterates(loop))
            visit(s, ir_child(loop, 3));
    } else {
        visit(s, ir_child(loop, 0)); /* the condition, or the body of a do loop */
    }
    s->may_have_left = may_have_left; /* jumps of an inner loop end there; loops with other jumps
                                       * are refused */
}

/** Visits what is read when an object's address is computed: &e->rest[t] reads the pointer e->rest,
 * and t, but not the element. */
static void visit_address(search *s, const ir_node *object) {
    const ir_node *first = ir_child(object, 0);
    switch (object->kind) {
    case IR_VARIABLE:
        return;
    case IR_MEMBER:
        if (object->flags & IR_ARROW)
            visit(s, first);
        else
            visit_address(s, first);
        return;
    case IR_INDEX:
        if (first->type->kind == IR_ARRAY)
            visit_address(s, first);
        else
            visit(s, first);
        visit(s, ir_child(object, 1));
        return;
    default: /* *p */
        for (unsigned i = 0; i < object->child_count; i++)
            visit(s, object->children[i]);
        return;
    }
}

/** The pointer p of p->a.b, or NULL if the node is no member reached by a pointer. */
static const ir_node *structure_of(const ir_node *node) {
    while (node->kind == IR_MEMBER && !(node->flags & IR_ARROW))
        node = ir_child(node, 0);
    return node->kind == IR_MEMBER ? ir_child(node, 0) : NULL;
}

/** Is the node the expression `wanted`, or another member of the same structure? If p->a is read, p
 * points to a whole structure, so p->b may be read too. */
static bool matches(const search *s, const ir_node *node) {
    if (!ir_is_expression(node))
        return false;
    const ir_node *other = structure_of(node);
    if (s->parameter)
        return other && other->kind == IR_VARIABLE && other->variable == s->parameter;
    const ir_node *structure = structure_of(s->wanted);
    return syntax_same(node, s->wanted) || (structure && other && syntax_same(other, structure));
}

/** Visits those reads of the structure A that a function, called as find(A, i, j), always makes. */
static void visit_callee(search *s, const ir_node *call) {
    const ir_node *callee = ir_child(call, 0);
    const ir_node *structure = s->parameter ? NULL : structure_of(s->wanted);
    if (s->is_found || callee->kind != IR_FUNCTION || !callee->function->body ||
        callee->function->linkage.is_weak)
        return;
    const ir_function *function = callee->function;
    for (unsigned i = 0; i < function->parameter_count && i + 1 < call->child_count; i++) {
        const ir_node *given = call->children[i + 1];
        const ir_variable *parameter = function->parameters[i];
        const bool is_it = s->parameter
                               ? given->kind == IR_VARIABLE && given->variable == s->parameter
                               : structure && syntax_same(given, structure);
        if (!is_it || !ir_type_equal(given->type, parameter->type) ||
            variable_is_written_in(function->body, parameter))
            continue;
        search inside = {.facts = s->facts, .parameter = parameter};
        visit(&inside, function->body);
        s->is_found |= inside.is_found;
    }
}

/** Visits the address that a call such as mat_add(m, r, c, v) updates. The call's text does not
 *  contain this address, because only the callee names it. */
static void visit_called_update(search *s, const ir_node *statement) {
    for (unsigned i = 0; i < s->facts->update_count; i++) {
        const reduction_update *update = &s->facts->updates[i];
        if (update->statement == statement && !ir_contains(statement, update->target))
            visit_address(s, update->target);
    }
}

static void visit(search *s, const ir_node *node) {
    if (s->is_found || s->may_have_left)
        return;
    if (matches(s, node)) {
        s->is_found = true;
        return;
    }
    switch (node->kind) {
    case IR_EXPRESSION:
        visit(s, ir_child(node, 0));
        visit_called_update(s, node);
        return;
    case IR_IF:
    case IR_SWITCH:
        visit(s, ir_child(node, 0));
        s->may_have_left |= ir_any(node, ir_is_jump);
        return;
    case IR_FOR:
    case IR_WHILE:
    case IR_DO:
        visit_inner_loop(s, node);
        return;
    case IR_CONDITIONAL:
        visit(s, ir_child(node, 0));
        return;
    case IR_BINARY:
        visit(s, ir_child(node, 0));
        if (node->op != IR_OP_AND && node->op != IR_OP_OR)
            visit(s, ir_child(node, 1));
        return;
    case IR_UNARY:
        if (node->op == IR_OP_ADDRESS)
            visit_address(s, ir_child(node, 0));
        else
            visit(s, ir_child(node, 0));
        return;
    case IR_OPAQUE:
        return;
    case IR_CALL:
        for (unsigned i = 0; i < node->child_count; i++)
            visit(s, node->children[i]);
        visit_callee(s, node);
        return;
    default:
        for (unsigned i = 0; i < node->child_count; i++)
            visit(s, node->children[i]);
        s->may_have_left |= ir_is_jump(node);
        return;
    }
}

static bool is_certain(const loop_facts *facts, const ir_node *wanted) {
    const counted_loop *counted = &facts->counted;
    search s = {.facts = facts, .wanted = wanted};
    if (counted->lower)
        visit(&s, counted->lower);
    visit(&s, counted->bound);
    visit(&s, counted->body);
    return s.is_found;
}

/* ---- possible failures ----------------------------------------------------------------------- */

static bool value_is_safe(const loop_facts *facts, const ir_node *node);

/** Does reading this object go through a pointer, or a subscript that may be out of bounds? */
static bool may_fail_to_read(const ir_node *node) {
    switch (node->kind) {
    case IR_VARIABLE:
        return false;
    case IR_MEMBER:
        return (node->flags & IR_ARROW) || may_fail_to_read(ir_child(node, 0));
    case IR_INDEX:
        return ir_child(node, 0)->type->kind != IR_ARRAY ||
               !(ir_child(node, 1)->flags & IR_HAS_VALUE) || may_fail_to_read(ir_child(node, 0));
    default:
        return true;
    }
}

static bool children_are_safe(const loop_facts *facts, const ir_node *node) {
    for (unsigned i = 0; i < node->child_count; i++)
        if (!value_is_safe(facts, node->children[i]))
            return false;
    return true;
}

/** Is it safe to compute the lvalue's address? Only pointers and subscripts in it are read. */
static bool address_is_safe(const loop_facts *facts, const ir_node *node) {
    const ir_node *first = ir_child(node, 0);
    switch (node->kind) {
    case IR_VARIABLE:
        return true;
    case IR_MEMBER:
        return node->flags & IR_ARROW ? value_is_safe(facts, first) : address_is_safe(facts, first);
    case IR_INDEX:
        return (first->type->kind == IR_ARRAY ? address_is_safe(facts, first)
                                              : value_is_safe(facts, first)) &&
               value_is_safe(facts, ir_child(node, 1));
    case IR_UNARY:
        if (node->op == IR_OP_DEREFERENCE && first->type->kind == IR_ARRAY)
            return address_is_safe(facts, first);
        return value_is_safe(
            facts, node->op == IR_OP_DEREFERENCE && first->type->kind == IR_POINTER ? first : node);
    default:
        return value_is_safe(facts, node);
    }
}

static bool value_is_safe(const loop_facts *facts, const ir_node *node) {
    switch (node->kind) {
    case IR_VARIABLE:
    case IR_NUMBER:
    case IR_STRING:
    case IR_FUNCTION:
    case IR_SIZEOF:
        return true;
    case IR_MEMBER:
    case IR_INDEX:
        if (node->type->kind == IR_ARRAY || !may_fail_to_read(node))
            return address_is_safe(facts, node);
        return is_certain(facts, node);
    case IR_UNARY:
        if (node->op == IR_OP_ADDRESS)
            return address_is_safe(facts, ir_child(node, 0));
        if (node->op == IR_OP_DEREFERENCE)
            return node->type->kind == IR_ARRAY ? value_is_safe(facts, ir_child(node, 0))
                                                : is_certain(facts, node);
        return children_are_safe(facts, node);
    case IR_BINARY:
        if (node->op == IR_OP_DIVIDE || node->op == IR_OP_REMAINDER) {
            const ir_node *divisor = ir_child(node, 1);
            const bool can_fail =
                !(divisor->flags & IR_HAS_VALUE) || divisor->value == 0 || divisor->value == -1;
            if (can_fail && node->type->kind == IR_INTEGER)
                return is_certain(facts, node);
        }
        return children_are_safe(facts, node);
    case IR_CONDITIONAL:
    case IR_CAST:
        return children_are_safe(facts, node);
    default:
        return is_certain(facts, node);
    }
}

/* ---- the loop's own expressions ------------------------------------------------------------- */

/** Is it safe to read the base before the loop? If it is an array, only its address is computed. */
static bool base_is_safe(const loop_facts *facts, const ir_node *base) {
    return base->type->kind == IR_ARRAY ? address_is_safe(facts, base) : value_is_safe(facts, base);
}

void plan_reads_ahead(loop_plan *plan) {
    assert(plan->sources && !plan->has_ready_base);
    const loop_facts *facts = plan->facts;
    for (unsigned i = 0; i < facts->array_count; i++)
        if (!facts->arrays[i].is_scattered && !base_is_safe(facts, facts->arrays[i].base))
            plan_obstacle(plan, facts->arrays[i].base->range,
                          "'%s' is read in some iterations only, and may not be valid before",
                          facts->arrays[i].name);
    for (unsigned i = 0; i < plan->source_count; i++) {
        const loop_source *fact = plan->sources[i].fact;
        if (fact->extent != EXTENT_TOUCHED && fact->extent != EXTENT_BOUNDED &&
            !address_is_safe(facts, fact->row))
            plan_obstacle(plan, fact->row->range,
                          "'%s' is read in some iterations only, and may not be valid before",
                          fact->name);
    }
    for (unsigned i = 0; i < facts->inspector.key_count; i++)
        if (!base_is_safe(facts, facts->inspector.key[i]))
            plan_obstacle(plan, facts->inspector.key[i]->range,
                          "what the subscripts depend on is read in some iterations only, and may "
                          "not be valid before");
    bool *has_ready_base = ARENA_ARRAY(plan->arena, bool, facts->source_count + 1);
    for (unsigned i = 0; i < facts->source_count; i++)
        has_ready_base[i] = facts->sources[i].base && base_is_safe(facts, facts->sources[i].base);
    plan->has_ready_base = has_ready_base;
}
