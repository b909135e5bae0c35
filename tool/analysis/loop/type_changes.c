/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/loop/type_changes.h"

#include "analysis/base/expression.h"
#include "analysis/loop/own.h"

/* Does every evaluation of the expression read the lvalue? */
static bool is_read_by(const ir_node *lvalue, const ir_node *expression) {
    if (expression_same(expression, lvalue))
        return true;
    const bool is_partly = expression->kind == IR_CONDITIONAL ||
                           (expression->kind == IR_BINARY &&
                            (expression->op == IR_OP_AND || expression->op == IR_OP_OR));
    if (expression->kind == IR_SIZEOF || expression->kind == IR_OPAQUE)
        return false;
    for (unsigned i = 0; i < (is_partly ? 1 : expression->child_count); i++)
        if (is_read_by(lvalue, expression->children[i]))
            return true;
    return false;
}

static bool update_reads_first(const loop_analysis *j, const access *update) {
    const update_form *form = &update->form;
    if (update->kind == ACCESS_UPDATE && form->has_operator)
        return true;
    if (update->callee || !update->lvalue)
        return false;
    if (update->kind == ACCESS_UPDATE && form->value && is_read_by(form->target, form->value))
        return true;
    for (unsigned i = 0; i < j->updates.count; i++) {
        const ir_node *statement = j->updates.items[i].statement;
        if (statement->kind == IR_IF && ir_contains(statement, update->node))
            return is_read_by(update->lvalue, statement->children[0]);
    }
    return false;
}

bool access_reads_first(const loop_analysis *j, const loop_access *a) {
    const int own = !a->access.callee && a->access.lvalue ? own_named(j, a->access.lvalue) : -1;
    if (own >= 0)
        return !j->own.items[own].is_stored_first;
    return a->access.kind == ACCESS_READ || update_reads_first(j, &a->access);
}

overlap accesses_overlap(const loop_analysis *j, const loop_access *a, const loop_access *b) {
    return access_reads_first(j, a) && access_reads_first(j, b)
               ? locations_overlap(&j->an->rules, &a->where, &b->where)
               : locations_overlap_store(&j->an->rules, &a->where, &b->where);
}
