/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/independent.h"

#include <string.h>

#include "analysis/base/openmp_loop.h"
#include "analysis/base/openmp_nest.h"
#include "ir/ir_syntax.h"

/* May the clauses give several iterations to a chosen thread? */
static bool chooses_threads(const openmp_loop *openmp) {
    for (unsigned i = 0; i < openmp->item_count; i++) {
        const openmp_item *item = &openmp->items[i];
        if (item->kind == OPENMP_IF || item->kind == OPENMP_NUM_THREADS ||
            (item->kind == OPENMP_SCHEDULE && !strstr(item->text, "dynamic") &&
             !strstr(item->text, "guided")))
            return true;
    }
    return openmp->is_of_team;
}

/* Is the node in a loop within one iteration? The loops that `collapse` names are not: each of
 * their iterations is one of the directive's. */
static bool is_repeated(const loop_facts *facts, const ir_node *node) {
    const openmp_loop *openmp = facts->variables.openmp;
    const openmp_directive read = {.item_count = openmp->item_count, .items = openmp->items};
    const ir_node *innermost = facts->loop;
    for (unsigned depth = openmp_depth(&read); depth > 1 && innermost; depth--)
        innermost = openmp_inner_loop(innermost);
    for (; node != innermost; node = node->parent)
        if (!node || node == facts->loop || ir_is_loop(node))
            return true;
    return false;
}

static bool is_target(const loop_facts *facts, const ir_node *node) {
    for (unsigned i = 0; i < facts->update_count; i++)
        if (syntax_same(facts->updates[i].target, node))
            return true;
    return false;
}

/* Is the address of this read known before the loop, or is the read disjoint from all updates? */
static bool is_compared_before(const loop_facts *facts, const ir_node *node) {
    bool is_source = false;
    for (unsigned i = 0; i < facts->source_count; i++) {
        const loop_source *read = &facts->sources[i];
        if (!syntax_same(read->row, node))
            continue;
        if (read->needs_guard && read->extent == EXTENT_TOUCHED)
            return false;
        is_source = true;
    }
    return is_source;
}

/* Does the tree, from node number `from` on, contain a read that may depend on the updates? */
static bool reads_later(const loop_facts *facts, const ir_node *node, unsigned from) {
    const bool is_later = node->id >= from;
    if (is_later && (node->kind == IR_CALL || node->kind == IR_OPAQUE))
        return true;
    if (is_later && ir_reads_memory(node) && !is_target(facts, node) &&
        !is_compared_before(facts, node))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (reads_later(facts, node->children[i], from))
            return true;
    return false;
}

/* The number of the first node after the tree. */
static unsigned after(const ir_node *node) {
    while (node->child_count > 0)
        node = node->children[node->child_count - 1];
    return node->id + 1;
}

bool reads_are_independent(const loop_plan *plan) {
    const loop_facts *facts = plan->facts;
    const openmp_loop *openmp = facts->variables.openmp;
    const ir_node *const body = facts->counted.body;
    if (!openmp || !openmp->has_locks || chooses_threads(openmp) || facts->update_count == 0 ||
        openmp->has_critical || ir_may_be_entered(body))
        return false;
    const reduction_update *first = &facts->updates[0];
    for (unsigned i = 0; i < facts->update_count; i++) {
        const reduction_update *update = &facts->updates[i];
        if (is_repeated(facts, update->statement))
            return false;
        first = update->statement->id < first->statement->id ? update : first;
    }
    return !first->last && !reads_later(facts, body, after(first->statement));
}
