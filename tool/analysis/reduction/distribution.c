/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A store t[i + c] = v or t[i + c] op= v may be made after all iterations under these conditions:
 * - it is in the body's outermost block, or in a branch there whose condition uses only the
 *   counter, the element and invariants;
 * - each iteration reaches it: there is no `continue` (a loop with `break` is refused anyway);
 * - its subscript has a different value in each iteration, and the counter is the only operand of
 *   the subscript, t and v that changes. The stores made after the loop then store the same values
 *   in the same order;
 * - any other read in the loop that may touch a stored element reads t[i + c] itself, earlier in
 *   the same iteration, so it still finds the old value;
 * - at least one such read is made in every iteration. So the extent that the guard compares with
 *   each reduction array contains all stored elements, and no update changes a stored element. Each
 *   element also has t's type when the deferred store is made: the loop no longer stores to
 *   it, so reading it as another type would be undefined (C17 6.5p7). */
#include "analysis/reduction/distribution.h"

#include "analysis/base/expression.h"
#include "analysis/loop/own.h"

/* ---- the form of such a store ---------------------------------------------------------------- */

static bool is_value(const loop_analysis *j, const ir_node *node) {
    if (node->kind == IR_UNARY && node->op == IR_OP_MINUS)
        return node->children[0]->kind == IR_NUMBER;
    return analysis_is_fixed(j, node) && node->type->kind != IR_POINTER;
}

static bool may_be_distributed(const loop_analysis *j, const ir_node *statement) {
    const ir_node *store = statement->kind == IR_EXPRESSION ? statement->children[0] : NULL;
    if (!store || store->kind != IR_ASSIGN || statement->range.begin >= statement->range.end ||
        (statement->flags | store->flags) & (IR_FROM_MACRO | IR_FROM_CALL))
        return false;
    const ir_node *target = store->children[0];
    const ir_type *type = target->type;
    return target->kind == IR_INDEX && !type->is_volatile && !type->is_atomic &&
           (type->kind == IR_INTEGER || type->kind == IR_FLOATING) && own_is_element(j, target) &&
           is_value(j, store->children[1]);
}

/* Does the expression have the same value after all iterations as at the store? It may use
 * invariants, the counter and the element itself. It must not contain floating-point operations,
 * because a second copy of these may round differently. */
static bool is_repeatable(const loop_analysis *j, const ir_node *node, const ir_node *target) {
    if (expression_same(node, target) || expression_is_variable(node, j->counted.counter) ||
        analysis_is_fixed(j, node))
        return true;
    if ((node->kind != IR_BINARY && node->kind != IR_UNARY && node->kind != IR_CAST) ||
        node->op == IR_OP_DEREFERENCE || expression_is_floating_work(node))
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!is_repeatable(j, node->children[i], target))
            return false;
    return expression_is_plain(node);
}

typedef VECTOR(distributed_store) store_list;

static void add_store(const loop_analysis *j, ir_node *statement, const ir_node *condition,
                      store_list *list) {
    if (!may_be_distributed(j, statement))
        return;
    const ir_node *assignment = statement->children[0];
    if (condition && !is_repeatable(j, condition, assignment->children[0]))
        return;
    ir_node *rest = ir_new(j->an->memory, IR_BLOCK, NULL, 0);
    rest->id = statement->id;
    rest->parent = statement->parent;
    rest->range = (ir_range){statement->range.begin, statement->range.begin};
    const distributed_store item = {statement, rest, assignment, condition};
    VECTOR_PUSH(j->an->memory, list, item);
}

/* Adds the stores under a condition, as in if (t[i] != 0) { ...; t[i] = 0; } */
static void add_stores_if(const loop_analysis *j, const ir_node *branch, store_list *list) {
    if (branch->kind != IR_IF || branch->child_count != 2)
        return;
    ir_node *then = branch->children[1];
    if (then->kind != IR_BLOCK)
        add_store(j, then, branch->children[0], list);
    for (unsigned i = 0; then->kind == IR_BLOCK && i < then->child_count; i++)
        add_store(j, then->children[i], branch->children[0], list);
}

const distribution *distribution_find(const loop_analysis *j) {
    const ir_node *body = j->counted.body;
    if (!body || j->counted.counter->type->kind != IR_INTEGER || j->counted.steps_inside ||
        j->counted.steps_first || ir_continues(body))
        return NULL;
    store_list list = {0};
    add_stores_if(j, body, &list);
    for (unsigned i = 0; body->kind == IR_BLOCK && i < body->child_count; i++) {
        add_store(j, body->children[i], NULL, &list);
        add_stores_if(j, body->children[i], &list);
    }
    if (list.count == 0)
        return NULL;
    distribution *result = ARENA_NEW(j->an->memory, distribution);
    *result = (distribution){list.count, list.items};
    return result;
}

/* ---- may the store be deferred? -------------------------------------------------------------- */

static bool is_read_before(const loop_access *read, const distributed_store *store) {
    return read->access.kind == ACCESS_READ && !read->access.callee && read->access.lvalue &&
           read->access.is_exact && read->access.node->id < store->statement->id &&
           expression_same(read->access.lvalue, store->assignment->children[0]);
}

static bool is_legal(const loop_analysis *j, const distributed_store *store) {
    const ir_node *target = store->assignment->children[0];
    location where = location_of(j->an->facts, target, j->loop);
    where.type = target->type;
    bool is_read_always = false;
    if (where.is_inexact || where.is_punned || where.has_union || where.has_bit_field)
        return false;
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *other = &j->accesses[i];
        if (is_read_before(other, store))
            is_read_always |= !other->access.is_conditional;
        else if (other->access.kind == ACCESS_READ &&
                 locations_overlap(&j->an->rules, &other->where, &where) != OVERLAP_NO)
            return false;
    }
    return is_read_always;
}

reason check_distribution(const loop_analysis *j) {
    for (unsigned i = 0; j->left_out.distribution && i < j->left_out.distribution->count; i++) {
        const distributed_store *store = &j->left_out.distribution->stores[i];
        if (!is_legal(j, store))
            return analysis_reason(j, REASON_OTHER_STORE, store->statement,
                                   analysis_name(j, store->assignment->children[0]));
    }
    return (reason){0};
}
