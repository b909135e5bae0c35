/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/unverified_uses.h"

#include "analysis/base/expression.h"
#include "ir/ir_syntax.h"
#include "plan/bins.h"
#include "plan/branch.h"
#include "plan/unconditional.h"

enum { DEEPEST_CALL = 6 };

static bool is_evaluated_anyway(const unverified_reads *s, const ir_node *node) {
    for (unsigned i = 0; i < s->certain.count; i++)
        if (syntax_same(s->certain.items[i], node))
            return true;
    return false;
}

/** Is the node part of an update that the inspector logs under fewer conditions than the loop makes
 *  it? The inspector then reads the update's subscripts in any case. */
static bool is_subscript_of_unconditional_update(const unverified_reads *s, const ir_node *node) {
    const loop_facts *facts = s->plan->facts;
    for (unsigned i = 0; i < facts->update_count; i++)
        if (ir_contains(facts->updates[i].target, node))
            return is_unconditional(facts, facts->updates[i].statement);
    return false;
}

/** Is the node a member, or an element with a constant subscript, of a local variable? Such a node
 * can always be read. */
static bool is_fixed_part(const ir_node *node) {
    for (; node->kind != IR_VARIABLE; node = node->children[0]) {
        const bool is_element = node->kind == IR_INDEX && node->children[1]->flags & IR_HAS_VALUE;
        if ((!is_element && node->kind != IR_MEMBER) || !node->children[0]->type ||
            node->children[0]->type->kind == IR_POINTER)
            return false;
    }
    return node->variable->storage == IR_LOCAL;
}

static void check_access(unverified_reads *s, const ir_node *node, control how) {
    for (unsigned i = 0; i < node->child_count; i++) {
        const ir_node *child = node->children[i];
        const bool is_address = child->type && child->type->kind == IR_POINTER;
        const bool is_subscript = node->kind == IR_INDEX && i == 1;
        s->is_harmful |= (is_address || is_subscript) && unverified_value(s, child);
    }
    if (!ir_reads_memory(node) || (node->parent && ir_is_address_of(node->parent)))
        return;
    if (how.is_certain)
        VECTOR_PUSH(s->plan->arena, &s->certain, node);
    else if (how.is_unverified && !is_fixed_part(node))
        s->is_harmful |=
            !is_evaluated_anyway(s, node) && !is_subscript_of_unconditional_update(s, node);
}

static bool is_division(const ir_node *node) {
    return (node->kind == IR_BINARY || node->kind == IR_ASSIGN) &&
           (node->op == IR_OP_DIVIDE || node->op == IR_OP_REMAINDER) && node->type &&
           node->type->kind == IR_INTEGER;
}

static void check_division(unverified_reads *s, const ir_node *node, control how) {
    const ir_node *divisor = node->children[1];
    const bool is_safe =
        (divisor->flags & IR_HAS_VALUE) && divisor->value != 0 && divisor->value != -1;
    s->is_harmful |= !is_safe && (how.is_unverified || unverified_part(s, node));
}

static void check_callee(unverified_reads *s, const ir_node *call) {
    const ir_function *callee = call->children[0]->function;
    const unsigned count = callee->parameter_count;
    if (s->depth == DEEPEST_CALL || callee->is_variadic || call->child_count != count + 1) {
        s->is_harmful = true;
        return;
    }
    unverified_reads inner = unverified_begin_callee(s, call);
    unverified_check(&inner, callee->body, (control){false, false});
    s->is_harmful |= inner.is_harmful;
}

/** Is a call of a function without a body harmless? System functions on numbers accept any values.
 *  Other functions may do anything with unverified values. */
static bool is_harmless_unseen(const unverified_reads *s, const ir_node *call, control how) {
    const bool is_known = ir_called_function(call)->is_from_system;
    for (unsigned i = 1; i < call->child_count; i++)
        if (may_hold_address(call->children[i]->type) ||
            (!is_known && unverified_value(s, call->children[i])))
            return false;
    return is_known || !how.is_unverified;
}

static void check_call(unverified_reads *s, const ir_node *call, control how) {
    const ir_function *callee = ir_called_function(call);
    if (!callee || (how.is_unverified && callee->body)) {
        s->is_harmful = true;
        return;
    }
    for (unsigned i = 1; i < call->child_count; i++)
        s->is_harmful |= call->children[i]->type && call->children[i]->type->kind == IR_POINTER &&
                         unverified_value(s, call->children[i]);
    if (callee->body)
        check_callee(s, call);
    else
        s->is_harmful |= !is_harmless_unseen(s, call, how);
}

control unverified_below(const unverified_reads *s, const ir_node *node, control how, bool first) {
    const bool decides =
        node->kind == IR_IF || node->kind == IR_CONDITIONAL || node->kind == IR_SWITCH ||
        ir_is_loop(node) ||
        (node->kind == IR_BINARY && (node->op == IR_OP_AND || node->op == IR_OP_OR));
    if (!decides || (first && node->kind != IR_DO))
        return how;
    return (control){how.is_unverified || unverified_condition(s, node), false};
}

/** Is the node a `continue` of the analysed loop itself? */
static bool is_next_iteration(const unverified_reads *s, const ir_node *node) {
    if (node->kind != IR_CONTINUE || s->in_callee)
        return false;
    while (!ir_is_loop(node))
        node = node->parent;
    return node == s->plan->facts->loop;
}

/** Is the node the lvalue, or a part of its path up to the pointer or variable that leads to it? */
static bool is_part_of(const ir_node *node, const ir_node *lvalue) {
    while (ir_is_access(lvalue)) {
        const ir_node *first = lvalue->children[0];
        if (expression_same(node, lvalue))
            return true;
        if (!first->type || first->type->kind == IR_POINTER)
            return false;
        lvalue = first;
    }
    return false;
}

/** Is the node part of an updated element or scalar, or the pointer to a scattered row? In bins the
 * body only computes the element's address, and stores the update in a record or in a private copy
 * of the row. A row's pointer is loaded only if its address is readable (REDCC_ELEMENT_BEHIND). */
static bool is_updated_in_bins(const unverified_reads *s, const ir_node *node) {
    const loop_facts *facts = s->plan->facts;
    if (s->in_slice || s->in_callee)
        return false;
    for (unsigned i = 0; i < facts->scalar_count; i++) {
        const scalar_update *scalar = &facts->scalars[i];
        if (!scalar->is_extremum && ir_contains(scalar->statement, node) &&
            is_part_of(node, scalar->target))
            return true;
    }
    for (unsigned i = 0; i < facts->update_count; i++)
        if (ir_contains(facts->updates[i].statement, node) &&
            (is_part_of(node, facts->updates[i].target) ||
             node == row_load_of(facts, &facts->updates[i])))
            return true;
    return false;
}

/** May the loop, executed where the program would not execute it, run forever? */
static bool may_not_end(const unverified_reads *s, const ir_node *loop, control how) {
    return how.is_unverified && !s->in_callee && !ends_in_any_case(s->plan->facts, loop);
}

void unverified_check(unverified_reads *s, const ir_node *node, control how) {
    how.is_unverified |= s->may_have_left;
    if (ir_is_loop(node))
        s->is_harmful |= unverified_condition(s, node) || may_not_end(s, node, how);
    if (ir_is_access(node) && is_updated_in_bins(s, node))
        ; /* its subscripts are checked below */
    else if (ir_is_access(node))
        check_access(s, node, how);
    else if (is_division(node))
        check_division(s, node, how);
    else if (node->kind == IR_CALL)
        check_call(s, node, how);
    else if (s->in_slice && how.is_unverified && is_next_iteration(s, node))
        s->may_have_left = true; /* the program may not execute the `continue` */
    else if (node->kind == IR_OPAQUE || (ir_is_jump(node) && how.is_unverified) ||
             (node->kind == IR_DECLARATOR && node->variable->type->size < 0))
        s->is_harmful = true;
    for (unsigned i = 0; i < node->child_count && !s->is_harmful; i++)
        unverified_check(s, node->children[i], unverified_below(s, node, how, i == 0));
}

control unverified_in_iteration(const loop_plan *plan) {
    /* in a body with a jump no statement is certain: the jump may skip it */
    return (control){false, !ir_any(plan->facts->counted.body, ir_is_jump)};
}

bool is_harmless_when_unverified(const loop_plan *plan) {
    const bool *is_suspect = guarded_sources(plan);
    if (!unverified_has_suspects(plan, is_suspect))
        return true;
    unverified_reads s = unverified_begin(plan, is_suspect, false);
    unverified_check(&s, plan->facts->counted.body, unverified_in_iteration(plan));
    return !s.is_harmful;
}
