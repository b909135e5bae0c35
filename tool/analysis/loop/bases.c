/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/loop/bases.h"

#include "analysis/base/expression.h"

/* The pointer that evaluating the lvalue dereferences last; NULL if it dereferences none. */
static const ir_node *dereferenced(const ir_node *node) {
    const ir_node *child = node->child_count ? node->children[0] : NULL;
    bool child_is_array = child && child->type && child->type->kind == IR_ARRAY;
    switch (node->kind) {
    case IR_MEMBER:
        return (node->flags & IR_ARROW) && !child_is_array ? child : dereferenced(child);
    case IR_INDEX:
        return child_is_array ? dereferenced(child) : child;
    case IR_UNARY:
        return node->op == IR_OP_DEREFERENCE && !child_is_array ? child : dereferenced(child);
    case IR_CAST:
        return dereferenced(child);
    default:
        return NULL;
    }
}

static bool dereferences(const ir_node *lvalue, const ir_node *pointer) {
    if (expression_is_lvalue(lvalue) && lvalue->kind != IR_VARIABLE) {
        const ir_node *through = dereferenced(lvalue);
        if (through && expression_same(through, pointer))
            return true;
    }
    return false;
}

static bool list_dereferences(const access_list *list, const ir_node *pointer) {
    for (unsigned i = 0; i < list->items.count; i++) {
        const access *a = &list->items.items[i];
        if (!a->is_conditional && a->lvalue && dereferences(a->lvalue, pointer))
            return true;
    }
    return false;
}

static bool is_subscript(const ir_node *node) {
    return node->kind == IR_INDEX;
}

/* Is the access made in each iteration? If a called function makes it, each call must make it once,
 * and to exactly `a->lvalue`. */
static bool is_certain(const access *a) {
    return !a->is_conditional &&
           (!a->callee || (a->lvalue && a->is_exact && !a->is_behind && !a->loop_count));
}

/* Does each iteration, or the loop's bound, read exactly `lvalue`? */
static bool is_read_anyway(const loop_analysis *j, const ir_node *lvalue) {
    for (unsigned i = 0; i < j->found.items.count; i++) {
        const access *a = &j->found.items.items[i];
        if (a->kind == ACCESS_READ && is_certain(a) && expression_same(a->lvalue, lvalue))
            return true;
    }
    return false;
}

bool base_is_in_object_read(const loop_analysis *j, const ir_node *load) {
    const ir_node *pointer = ir_any(load, is_subscript) ? NULL : dereferenced(load);
    return pointer && list_dereferences(&j->found, pointer);
}

bool base_can_be_read_before(const loop_analysis *j, const ir_node *base) {
    /* another element that the loop reads does not prove that this one exists */
    if (ir_any(base, is_subscript) && base->type && base->type->kind != IR_ARRAY)
        return is_read_anyway(j, base);
    const ir_node *pointer = dereferenced(base);
    if (!pointer || (base->type && base->type->kind == IR_ARRAY && pointer->kind == IR_VARIABLE))
        return true; /* p->b with an array b only computes an address */
    return list_dereferences(&j->found, pointer);
}
