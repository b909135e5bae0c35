/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/memory/access.h"

#include <string.h>

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "analysis/base/loop_exits.h"
#include "analysis/memory/access_walk.h"

void access_add(access_walk *w, access item) {
    item.is_conditional = item.is_conditional || w->condition_depth > 0;
    VECTOR_PUSH(w->memory, &w->list->items, item);
}

void access_problem_add(access_walk *w, reason_id why, const ir_node *node, const char *name) {
    access_problem problem = {why, node, name};
    VECTOR_PUSH(w->memory, &w->list->problems, problem);
}

/* Is the object, or a part of it, volatile or atomic, so that it must be accessed exactly as
 * written? */
static bool has_volatile_part(const ir_type *type) {
    type = ir_type_innermost(type);
    if (type->is_volatile || type->is_atomic)
        return true;
    const ir_record *record = type->kind == IR_RECORD ? type->record : NULL;
    for (unsigned i = 0; record && i < record->field_count; i++)
        if (has_volatile_part(record->fields[i].type))
            return true;
    return false;
}

/* Adds a problem if the lvalue is thread-local, volatile, atomic or in a named address space. */
static void check_type(access_walk *w, const ir_node *lvalue) {
    const ir_variable *root = ir_root_variable(lvalue);
    const char *name = root ? root->name : "?";
    if (lvalue->kind == IR_VARIABLE && lvalue->variable->storage == IR_THREAD_LOCAL)
        access_problem_add(w, REASON_THREAD_LOCAL, lvalue, name);
    if (lvalue->type && ir_type_innermost(lvalue->type)->has_address_space)
        access_problem_add(w, REASON_ADDRESS_SPACE, lvalue, name);
    if (lvalue->type && has_volatile_part(lvalue->type))
        access_problem_add(w, REASON_VOLATILE, lvalue, name);
    if (lvalue->kind == IR_MEMBER) {
        const ir_type *owner = lvalue->children[0]->type;
        if (owner && (lvalue->flags & IR_ARROW))
            owner = owner->target;
        if (owner && owner->has_address_space)
            access_problem_add(w, REASON_ADDRESS_SPACE, lvalue, name);
        if (owner && (owner->is_volatile || owner->is_atomic))
            access_problem_add(w, REASON_VOLATILE, lvalue, name);
    }
}

static void add_lvalue(access_walk *w, access_kind kind, const ir_node *lvalue, update_form form) {
    check_type(w, lvalue);
    access_add(w, (access){.kind = kind,
                           .lvalue = lvalue,
                           .is_exact = true,
                           .type = lvalue->type,
                           .node = lvalue,
                           .form = form});
}

/* Adds the accesses to pointers and subscripts that are made when an lvalue's address is
 * computed. */
static void walk_address(access_walk *w, const ir_node *node) {
    switch (node->kind) {
    case IR_VARIABLE:
        check_type(w, node);
        return;
    case IR_INDEX:
        if (ir_is_array(node->children[0]))
            walk_address(w, node->children[0]);
        else
            access_walk_node(w, node->children[0]);
        access_walk_node(w, node->children[1]);
        return;
    case IR_MEMBER:
        if ((node->flags & IR_ARROW) && !ir_is_array(node->children[0]))
            access_walk_node(w, node->children[0]);
        else if ((node->flags & IR_ARROW) || expression_is_lvalue(node->children[0]))
            walk_address(w, node->children[0]);
        else
            access_walk_node(w, node->children[0]);
        return;
    case IR_UNARY:
        if (node->op == IR_OP_DEREFERENCE) {
            if (ir_is_array(node->children[0]))
                walk_address(w, node->children[0]);
            else
                access_walk_node(w, node->children[0]);
            return;
        }
        access_walk_node(w, node);
        return;
    default:
        access_walk_node(w, node);
    }
}

/* Adds the accesses that are made when the value of `node` is read, except those of `skip`. In R =
 * R + e, `skip` is the R on the right. */
static void walk_skipping(access_walk *w, const ir_node *node, const ir_node *skip) {
    if (node == skip)
        return;
    const bool is_around = skip && node->kind == IR_UNARY && ir_contains(node, skip);
    if ((node->kind == IR_BINARY && skip) || is_around) {
        if (expression_is_floating_work(node))
            w->list->has_floating_work = true;
        for (unsigned i = 0; i < node->child_count; i++)
            walk_skipping(w, node->children[i], skip);
        return;
    }
    access_walk_node(w, node);
}

static void walk_assignment(access_walk *w, const ir_node *node) {
    update_form form = update_form_of(node);
    if (ir_is_complex_part(form.target))
        access_problem_add(w, REASON_OPAQUE, node, "assignment to a part of a complex number");
    walk_address(w, form.target);
    if (form.value)
        walk_skipping(w, form.value, form.has_operator ? form.self : NULL);
    if (form.is_update && !form.has_operator && node->op != IR_OP_NONE)
        form.self = NULL;
    add_lvalue(w, form.is_update ? ACCESS_UPDATE : ACCESS_WRITE, form.target, form);
}

static void walk_conditionally(access_walk *w, const ir_node *node) {
    w->condition_depth++;
    access_walk_node(w, node);
    w->condition_depth--;
}

static void walk_unary(access_walk *w, const ir_node *node) {
    if (node->op == IR_OP_ADDRESS) {
        walk_address(w, node->children[0]);
    } else if (node->op == IR_OP_DEREFERENCE) {
        walk_address(w, node);
        if (!ir_is_array(node))
            add_lvalue(w, ACCESS_READ, node, (update_form){0});
    } else if (expression_written(node)) {
        walk_assignment(w, node);
    } else {
        access_walk_node(w, node->children[0]);
    }
}

static void walk_for(access_walk *w, const ir_node *node) {
    const ir_variable *counter;
    int64_t first, last;
    bool is_certain =
        counted_constant(node, &counter, &first, &last) && !ir_leaves_loop(node->children[3]);
    access_walk_node(w, node->children[0]);
    access_walk_node(w, node->children[1]);
    w->condition_depth += is_certain ? 0 : 1;
    access_walk_node(w, node->children[3]);
    access_walk_node(w, node->children[2]);
    w->condition_depth -= is_certain ? 0 : 1;
}

static void walk_children(access_walk *w, const ir_node *node) {
    for (unsigned i = 0; i < node->child_count; i++)
        access_walk_node(w, node->children[i]);
}

static void walk_statement(access_walk *w, const ir_node *node) {
    switch (node->kind) {
    case IR_IF:
        access_walk_node(w, node->children[0]);
        walk_conditionally(w, node->children[1]);
        if (node->child_count > 2)
            walk_conditionally(w, node->children[2]);
        return;
    case IR_FOR:
        walk_for(w, node);
        return;
    case IR_WHILE:
    case IR_SWITCH:
        access_walk_node(w, node->children[0]);
        walk_conditionally(w, node->children[1]);
        return;
    case IR_CONTINUE:
    case IR_BREAK:
    case IR_RETURN:
        walk_children(w, node);
        w->condition_depth++; /* never decreased, because the code after it may be skipped */
        return;
    case IR_DECLARATOR:
        walk_children(w, node);
        if (has_volatile_part(node->variable->type))
            access_problem_add(w, REASON_VOLATILE, node, node->variable->name);
        return;
    default:
        walk_children(w, node);
    }
}

/* Is the node a function's result or a member of it, as in f().x? Such a member is a temporary
 * value, not an addressable object. */
static bool is_part_of_value(const ir_node *node) {
    while (node->kind == IR_MEMBER && !(node->flags & IR_ARROW))
        node = node->children[0];
    return node->kind == IR_CALL;
}

bool access_is_assertion(const ir_function *function) {
    return function->is_noreturn && strncmp(function->name, "__assert", 8) == 0;
}

/* Does the node name the function that a failed assertion calls? With gcc's extensions, glibc's
 * assert is a statement expression. */
static bool names_assertion(const ir_node *node) {
    return node->kind == IR_FUNCTION && access_is_assertion(node->function);
}

/* Handles an assertion in a called function: only its condition is evaluated, unless it fails.
 * Returns false if the node is no such assertion. */
static bool walk_assertion(access_walk *w, const ir_node *node) {
    const ir_node *condition = w->in_callee ? assertion_condition(node) : NULL;
    if (!condition)
        return false;
    access_walk_node(w, condition);
    VECTOR_PUSH(w->memory, &w->list->ends, node);
    w->condition_depth++; /* never decreased: a failure skips what follows */
    return true;
}

static void walk_opaque(access_walk *w, const ir_node *node) {
    if (walk_assertion(w, node))
        return;
    const char *atomic = access_walk_atomic(w, node);
    if (ir_any(node, names_assertion))
        access_problem_add(w, REASON_NO_RETURN, node, "assert");
    else if (atomic)
        access_problem_add(w, REASON_IMPURE_CALL, node, atomic);
    else
        access_problem_add(w, REASON_OPAQUE, node, node->text ? node->text : "?");
}

void access_walk_node(access_walk *w, const ir_node *node) {
    if (expression_is_floating_work(node))
        w->list->has_floating_work = true;
    switch (node->kind) {
    case IR_VARIABLE:
    case IR_INDEX:
    case IR_MEMBER:
        walk_address(w, node);
        if (!ir_is_array(node) && !is_part_of_value(node))
            add_lvalue(w, ACCESS_READ, node, (update_form){0});
        return;
    case IR_UNARY:
        walk_unary(w, node);
        return;
    case IR_ASSIGN:
        walk_assignment(w, node);
        return;
    case IR_BINARY:
        access_walk_node(w, node->children[0]);
        if (node->op == IR_OP_AND || node->op == IR_OP_OR)
            walk_conditionally(w, node->children[1]);
        else
            access_walk_node(w, node->children[1]);
        return;
    case IR_CONDITIONAL:
        if (walk_assertion(w, node))
            return;
        access_walk_node(w, node->children[0]);
        walk_conditionally(w, node->children[1]);
        walk_conditionally(w, node->children[2]);
        return;
    case IR_CALL:
        access_walk_call(w, node);
        return;
    case IR_OPAQUE:
        walk_opaque(w, node);
        return;
    case IR_GOTO:
    case IR_LABEL:
        access_problem_add(w, REASON_GOTO, node, node->text ? node->text : "?");
        walk_children(w, node);
        return;
    case IR_SIZEOF:
        return;
    default:
        walk_statement(w, node);
    }
}

static bool is_inside(const ir_node *subscript, const ir_type *array) {
    int64_t low, high;
    return array->count > 0 && counted_range(subscript, &low, &high) && low >= 0 &&
           high < array->count;
}

/* Is the lvalue an element or a pointer's target, or a member of one, and not a whole variable? */
static bool is_selected(const ir_node *lvalue) {
    while (lvalue->kind == IR_MEMBER && !(lvalue->flags & IR_ARROW))
        lvalue = lvalue->children[0];
    return lvalue->kind == IR_INDEX || lvalue->kind == IR_UNARY;
}

static const ir_node *without_proved(const ir_node *lvalue, bool may_be_whole) {
    const ir_node *row = lvalue;
    while (row->kind == IR_INDEX && ir_is_array(row->children[0]) &&
           is_inside(row->children[1], row->children[0]->type) &&
           (may_be_whole || is_selected(row->children[0])))
        row = row->children[0];
    return row;
}

const ir_node *access_row(const ir_node *lvalue) {
    return without_proved(lvalue, false);
}

const ir_node *access_extent(const ir_node *lvalue) {
    return without_proved(lvalue, true);
}
