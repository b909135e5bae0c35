/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Updates of a scalar (scalars.h) are made after the loop, so nothing else in the loop may read or
 * write the scalar. For members, elements and targets of pointers this is proved, or checked at run
 * time. An iteration with an update reads the object as a value of the object's type. An access of
 * another type that begins with a read must therefore access other memory (C17 6.5p7). A plain
 * store of another type, however, may follow the last update (6.5p6). */
#include "analysis/reduction/scalar_target.h"

#include "analysis/base/expression.h"
#include "analysis/loop/type_changes.h"

static bool is_steady_pointer(const loop_analysis *j, const ir_node *node) {
    return analysis_is_unchanged(j, node) && node->type->kind == IR_POINTER;
}

static bool is_invariant(const loop_analysis *j, const ir_node *node) {
    const ir_node *first = ir_child(node, 0);
    switch (node->kind) {
    case IR_VARIABLE:
        return node->variable->storage != IR_THREAD_LOCAL && !analysis_declares(j, node->variable);
    case IR_MEMBER:
        return node->flags & IR_ARROW ? is_steady_pointer(j, first) : is_invariant(j, first);
    case IR_INDEX:
        return (ir_child(node, 1)->flags & IR_HAS_VALUE) &&
               (first->type->kind == IR_ARRAY ? is_invariant(j, first)
                                              : is_steady_pointer(j, first));
    default:
        return node->kind == IR_UNARY && node->op == IR_OP_DEREFERENCE &&
               is_steady_pointer(j, first);
    }
}

static location location_of_target(const loop_analysis *j, const ir_node *target) {
    location where = location_of(j->an->facts, target, j->loop);
    where.type = target->type;
    return where;
}

bool scalar_target_is_invariant(const loop_analysis *j, const ir_node *target) {
    const location where = location_of_target(j, target);
    return target->kind != IR_VARIABLE && is_invariant(j, target) && !where.is_inexact &&
           !where.is_punned && !where.has_union && !where.has_bit_field;
}

/* Are a and b elements that differ in a constant subscript, such as e[0] and e[1], or m.x[2].y and
 * m.x[0].y? */
static bool are_other_elements(const ir_node *a, const ir_node *b) {
    if (!a || !b || a->kind != b->kind)
        return false;
    if (a->kind == IR_MEMBER)
        return a->field == b->field && are_other_elements(a->children[0], b->children[0]);
    return a->kind == IR_INDEX &&
           (are_other_elements(a->children[0], b->children[0]) ||
            (expression_same(a->children[0], b->children[0]) &&
             (a->children[1]->flags & b->children[1]->flags & IR_HAS_VALUE) &&
             a->children[1]->value != b->children[1]->value));
}

overlap scalar_target_overlap(const loop_analysis *j, const ir_node *target) {
    overlap worst = OVERLAP_NO;
    const location where = location_of_target(j, target);
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *a = &j->accesses[i];
        const bool is_named = !a->access.callee && a->access.lvalue && a->access.is_exact;
        if (is_named && (expression_same(a->access.lvalue, target) ||
                         are_other_elements(a->access.lvalue, target)))
            continue;
        const overlap meets = access_reads_first(j, a)
                                  ? locations_overlap(&j->an->rules, &a->where, &where)
                                  : locations_overlap_store(&j->an->rules, &a->where, &where);
        worst = meets > worst ? meets : worst;
    }
    return worst;
}
