/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/unverified.h"

#include <assert.h>

#include "analysis/base/expression.h"
#include "ir/ir_syntax.h"
#include "plan/branch.h"
#include "plan/independent.h"
#include "plan/lookup.h"

/* ---- unverified values ----------------------------------------------------------------------- */

bool unverified_part(const unverified_reads *s, const ir_node *node) {
    for (unsigned i = 0; i < node->child_count; i++)
        if (unverified_value(s, node->children[i]))
            return true;
    return false;
}

/** Is the path, or the base or row with which it begins, read from a source that may overlap a
 *  reduction array? `is_whole`: `path` is the complete path, not just its beginning. */
static bool depends_on_guarded(const unverified_reads *s, const ir_node *path, bool is_whole) {
    const loop_facts *facts = s->plan->facts;
    for (unsigned i = 0; i < facts->source_count; i++) {
        const loop_source *read = &facts->sources[i];
        if (s->is_suspect[i] && (!read->base || syntax_same(path, read->row) ||
                                 (!is_whole && syntax_same(path, read->base))))
            return true;
    }
    return path->child_count > 0 && path->kind != IR_CALL &&
           depends_on_guarded(s, path->children[0], false);
}

static bool is_of_row(const ir_node *path, const ir_node *row) {
    while (!syntax_same(path, row)) {
        if (path->child_count == 0 || path->kind == IR_CALL)
            return false;
        path = path->children[0];
        if (path->type && path->type->kind == IR_POINTER)
            return false;
    }
    return true;
}

/** Is the path a key, or part of a source that no update can overlap? All that the slice reads is a
 *  source or a key. */
static bool is_known_fresh(const unverified_reads *s, const ir_node *path) {
    const loop_facts *facts = s->plan->facts;
    bool is_known = false;
    for (unsigned i = 0; i < facts->source_count; i++)
        if (is_of_row(path, facts->sources[i].row)) {
            if (s->is_suspect[i])
                return false;
            is_known = true;
        }
    for (unsigned i = 0; i < facts->inspector.key_count; i++)
        is_known |= syntax_same(path, facts->inspector.key[i]);
    return is_known;
}

/** Is the path an own element that the iteration may have computed from an unverified value? */
static bool is_own(const unverified_reads *s, const ir_node *path) {
    return own_element_at(s->plan->facts, path) >= 0 &&
           unverified_has_suspects(s->plan, s->is_suspect);
}

static bool may_read_unverified(const unverified_reads *s, const ir_node *path) {
    return is_own(s, path) || (depends_on_guarded(s, path, true) && !is_known_fresh(s, path));
}

/** Does the path begin with a pointer that the iteration has computed? Its target is
 *  not analysed. */
static bool begins_with_private_pointer(const unverified_reads *s, const ir_node *path) {
    const ir_variable *root = ir_root_variable(path);
    return !root || (root->type->kind == IR_POINTER && !is_captured(s->plan->facts, root));
}

bool may_hold_address(const ir_type *type) {
    return !type || type->kind == IR_POINTER || type->kind == IR_ARRAY || type->kind == IR_RECORD;
}

/** May a read of this type in a called function read an unverified source? The caller's sources
 * include all reads of the callee that may overlap an update. If is_typed, the types of these
 * sources are compared with the read's. Otherwise the answer is always true. */
static bool callee_may_read_unverified(const unverified_reads *s, const ir_type *type) {
    for (unsigned i = 0; i < s->plan->facts->source_count; i++) {
        const ir_type *row = ir_type_innermost(s->plan->facts->sources[i].row->type);
        if (s->is_suspect[i] &&
            (row->kind == IR_RECORD || (row->kind == type->kind && row->size == type->size)))
            return true;
    }
    return !s->is_typed;
}

/** Does the value of a node in a called function depend on memory that may be unverified? */
static bool has_unverified_read(const unverified_reads *s, const ir_node *node) {
    const ir_variable *variable = node->kind == IR_VARIABLE ? node->variable : NULL;
    if (node->kind == IR_CALL || node->kind == IR_OPAQUE)
        return true;
    if ((ir_reads_memory(node) ||
         (variable && variable->storage != IR_LOCAL && variable->storage != IR_PARAMETER)) &&
        callee_may_read_unverified(s, node->type))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (has_unverified_read(s, node->children[i]))
            return true;
    return false;
}

/** Does the call pass a pointer computed by the iteration, whose target may have another type? */
static bool passes_private_memory(const unverified_reads *s, const ir_node *call) {
    for (unsigned i = 1; i < call->child_count; i++) {
        const ir_node *argument = call->children[i];
        const ir_variable *root =
            ir_root_variable(ir_is_address_of(argument) ? argument->children[0] : argument);
        if (may_hold_address(argument->type) &&
            (!root || ((root->storage == IR_LOCAL || root->storage == IR_PARAMETER) &&
                       !is_captured(s->plan->facts, root))))
            return true;
    }
    return false;
}

static bool call_is_unverified(const unverified_reads *s, const ir_node *call) {
    const ir_function *callee = ir_called_function(call);
    if (!callee || (callee->body && has_unverified_read(s, callee->body)))
        return true;
    const bool sees_memory = !callee->body || passes_private_memory(s, call);
    for (unsigned i = 1; i < call->child_count; i++)
        if ((sees_memory && may_hold_address(call->children[i]->type)) ||
            unverified_value(s, call->children[i]))
            return true;
    return false;
}

static bool variable_is_unverified(const unverified_reads *s, const ir_node *node) {
    const ir_variable *variable = node->variable;
    if (s->is_unverified[variable->id])
        return true;
    if (variable->storage == IR_LOCAL || variable->storage == IR_PARAMETER)
        return variable->address_taken && !is_captured(s->plan->facts, variable);
    return s->in_callee ? callee_may_read_unverified(s, node->type) : may_read_unverified(s, node);
}

static bool unverified_address(const unverified_reads *s, const ir_node *object) {
    if (object->kind == IR_VARIABLE)
        return false;
    if (!ir_is_access(object))
        return unverified_value(s, object);
    const ir_node *first = object->children[0];
    const bool is_inside = first->type && first->type->kind != IR_POINTER;
    return (is_inside ? unverified_address(s, first) : unverified_value(s, first)) ||
           (object->kind == IR_INDEX && unverified_value(s, object->children[1]));
}

bool unverified_value(const unverified_reads *s, const ir_node *node) {
    if (node->kind == IR_VARIABLE)
        return variable_is_unverified(s, node);
    if (node->kind == IR_OPAQUE)
        return true;
    if (node->kind == IR_CALL)
        return call_is_unverified(s, node);
    if (ir_is_address_of(node))
        return unverified_address(s, node->children[0]);
    if (ir_is_access(node) && !ir_reads_memory(node))
        return unverified_address(s, node);
    if (ir_reads_memory(node) &&
        (s->in_callee ? callee_may_read_unverified(s, node->type)
                      : may_read_unverified(s, node) ||
                            (!s->in_slice && begins_with_private_pointer(s, node))))
        return true;
    return unverified_part(s, node);
}

/* ---- marking ------------------------------------------------------------------------------- */

/** Marks the variable that a write modifies. A write through a pointer marks nothing: it modifies
 *  no variable, or one whose address was taken. */
static void mark(unverified_reads *s, const ir_node *lvalue) {
    const ir_variable *root = ir_root_variable(lvalue);
    const bool is_behind = root && root->type->kind == IR_POINTER && lvalue->kind != IR_VARIABLE;
    if (root && !is_behind && !s->is_unverified[root->id]) {
        s->is_unverified[root->id] = true;
        s->changed = true;
    }
}

/** Marks variables that a call may write through its arguments. Targets of pointers are not
 *  variables, so they are not marked. */
static void mark_arguments(unverified_reads *s, const ir_node *call) {
    for (unsigned i = 1; i < call->child_count; i++) {
        const ir_node *argument = call->children[i];
        if ((ir_is_address_of(argument) || (argument->type && argument->type->kind == IR_ARRAY)) &&
            call_is_unverified(s, call))
            mark(s, ir_is_address_of(argument) ? argument->children[0] : argument);
    }
}

bool unverified_condition(const unverified_reads *s, const ir_node *node) {
    switch (node->kind) {
    case IR_IF:
    case IR_CONDITIONAL:
    case IR_SWITCH:
    case IR_WHILE:
        return unverified_value(s, node->children[0]);
    case IR_FOR:
    case IR_DO:
        return node->children[1]->kind != IR_EMPTY && unverified_value(s, node->children[1]);
    case IR_BINARY:
        return (node->op == IR_OP_AND || node->op == IR_OP_OR) &&
               unverified_value(s, node->children[0]);
    default:
        return false;
    }
}

/** The conditions that decide whether a node is executed. */
typedef struct decision {
    bool is_unverified;    /* one of them is unverified */
    const ir_node *branch; /* if only `if` statements have unverified conditions: the branch of the
                            * innermost one; else NULL */
} decision;

static bool decides_value(const unverified_reads *s, decision by, const ir_node *lvalue) {
    const ir_variable *root = ir_root_variable(lvalue);
    return by.is_unverified && !(by.branch && root && !ir_is_access(lvalue) &&
                                 is_only_of_branch(s->plan->facts, by.branch, root));
}

static decision decided_below(const unverified_reads *s, const ir_node *node, unsigned part,
                              decision by) {
    if (!unverified_condition(s, node))
        return by;
    const bool is_branch =
        node->kind == IR_IF && part > 0 && !s->in_callee && (!by.is_unverified || by.branch);
    return (decision){true, is_branch ? node->children[part] : NULL};
}

static void propagate(unverified_reads *s, const ir_node *node, decision by) {
    const ir_node *written = expression_written(node);
    if (written && (decides_value(s, by, written) ||
                    unverified_value(s, node->children[node->child_count - 1])))
        mark(s, written);
    if (node->kind == IR_DECLARATOR && node->child_count > 0 &&
        unverified_value(s, node->children[0]) && !s->is_unverified[node->variable->id])
        s->is_unverified[node->variable->id] = s->changed = true;
    if (node->kind == IR_CALL)
        mark_arguments(s, node);
    for (unsigned i = 0; i < node->child_count; i++)
        propagate(s, node->children[i], decided_below(s, node, i, by));
}

static void propagate_to_fixed_point(unverified_reads *s, const ir_node *body) {
    do {
        s->changed = false;
        propagate(s, body, (decision){false, NULL});
    } while (s->changed);
}

/* ---- an iteration, a called function --------------------------------------------------------- */

bool *guarded_sources(const loop_plan *plan) {
    const loop_facts *facts = plan->facts;
    bool *is_guarded = ARENA_ARRAY(plan->arena, bool, facts->source_count + 1);
    const bool are_independent = reads_are_independent(plan);
    for (unsigned i = 0; i < facts->source_count; i++)
        is_guarded[i] = facts->sources[i].needs_guard &&
                        !(are_independent && facts->sources[i].extent == EXTENT_TOUCHED);
    return is_guarded;
}

bool unverified_has_suspects(const loop_plan *plan, const bool *is_suspect) {
    for (unsigned i = 0; i < plan->facts->source_count; i++)
        if (is_suspect[i])
            return true;
    return false;
}

unverified_reads unverified_begin(const loop_plan *plan, const bool *is_suspect, bool in_slice) {
    unverified_reads s = {.plan = plan,
                          .is_suspect = is_suspect,
                          .is_unverified =
                              ARENA_ARRAY(plan->arena, bool, plan->unit->variable_count + 1),
                          .in_slice = in_slice,
                          .is_typed = true};
    assert(is_suspect);
    propagate_to_fixed_point(&s, plan->facts->counted.body);
    return s;
}

unverified_reads unverified_begin_callee(const unverified_reads *s, const ir_node *call) {
    const ir_function *callee = ir_called_function(call);
    unverified_reads inner = {
        .plan = s->plan,
        .is_suspect = s->is_suspect,
        .is_unverified = ARENA_ARRAY(s->plan->arena, bool, s->plan->unit->variable_count + 1),
        .in_callee = true,
        .in_slice = s->in_slice,
        .is_typed = s->is_typed && !passes_private_memory(s, call),
        .depth = s->depth + 1};
    assert(callee && callee->body && callee->parameter_count + 1 == call->child_count);
    for (unsigned i = 0; i < callee->parameter_count; i++)
        inner.is_unverified[callee->parameters[i]->id] =
            callee->parameters[i]->type->kind != IR_POINTER &&
            unverified_value(s, call->children[i + 1]);
    propagate_to_fixed_point(&inner, callee->body);
    return inner;
}
