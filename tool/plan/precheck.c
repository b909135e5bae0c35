/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/precheck.h"

#include <assert.h>

#include "analysis/base/expression.h"
#include "ir/ir_syntax.h"
#include "plan/lookup.h"
#include "plan/unverified_uses.h"

/* ---- the slice ----------------------------------------------------------------------------- */

/** Checks the reads that computing &row makes. */
static void check_row(unverified_reads *s, const ir_node *row, control how) {
    if (row->kind == IR_VARIABLE)
        return;
    if (!expression_is_lvalue(row)) {
        unverified_check(s, row, how);
        return;
    }
    const ir_node *first = row->children[0];
    if (first->type && first->type->kind == IR_POINTER)
        unverified_check(s, first, how);
    else
        check_row(s, first, how);
    if (row->kind == IR_INDEX)
        unverified_check(s, row->children[1], how);
}

static void check_source(unverified_reads *s, const loop_source *read, control how) {
    for (unsigned i = 0; i < read->loop_count; i++) {
        unverified_check(s, read->loops[i].lower, how);
        unverified_check(s, read->loops[i].bound, how);
        s->is_harmful |=
            unverified_value(s, read->loops[i].lower) || unverified_value(s, read->loops[i].bound);
    }
    check_row(s, read->row, how);
}

static bool is_logged(const loop_plan *plan, unsigned number) {
    assert(number < plan->facts->source_count);
    return plan->facts->sources[number].extent == EXTENT_TOUCHED &&
           plan->source_number[number] != SOURCE_NOT_LOGGED;
}

static void check_logged_at(unverified_reads *s, const ir_node *place, control how) {
    const loop_facts *facts = s->plan->facts;
    for (unsigned i = 0; i < facts->source_count; i++)
        if (is_logged(s->plan, i) && facts->sources[i].place == place)
            check_source(s, &facts->sources[i], how);
}

/** Checks the addresses of the updates that the node makes. Returns false if it makes none. */
static bool check_updates_at(unverified_reads *s, const ir_node *node, control how) {
    const loop_facts *facts = s->plan->facts;
    bool is_update = false;
    for (unsigned i = 0; i < facts->update_count; i++)
        if (facts->updates[i].statement == node) {
            check_row(s, facts->updates[i].row, how);
            is_update = true;
        }
    const forwarded_store *store = forward_stored_by(facts, node);
    if (store && facts->slice.holds[node->id])
        unverified_check(s, store->value, how);
    return is_update;
}

/** Checks those parts of the node that the slice contains, and the addresses that it logs. */
static void check_held(unverified_reads *s, const ir_node *node, control how) {
    const loop_facts *facts = s->plan->facts;
    assert(node->id < facts->function->node_count);
    const bool is_held = facts->slice.holds[node->id];
    how.is_unverified |= s->may_have_left;
    check_logged_at(s, node, how);
    if (check_updates_at(s, node, how))
        return;
    if (node->kind == IR_EXPRESSION || node->kind == IR_DECLARATOR || node->child_count == 0) {
        if (is_held)
            unverified_check(s, node, how);
        return;
    }
    if (is_held && ir_is_loop(node) && !span_of(facts, node))
        s->is_harmful |= unverified_condition(s, node);
    for (unsigned i = 0; i < node->child_count; i++) {
        const ir_node *child = node->children[i];
        const control below = is_held ? unverified_below(s, node, how, i == 0) : how;
        if (child->kind >= IR_BLOCK)
            check_held(s, child, below);
        else if (is_held)
            unverified_check(s, child, below);
    }
}

static bool slice_is_harmed(loop_plan *plan, const bool *is_suspect) {
    if (!unverified_has_suspects(plan, is_suspect))
        return false;
    unverified_reads s = unverified_begin(plan, is_suspect, true);
    check_held(&s, plan->facts->counted.body, unverified_in_iteration(plan));
    return s.is_harmful;
}

/* ---- evaluated before the first iteration ---------------------------------------------------- */

/** Does the loop's header evaluate the expression? It does so before the first write. */
static bool is_in_header(const loop_facts *facts, const ir_node *part, const ir_node *node) {
    if (part == facts->counted.body)
        return false;
    if (syntax_same(part, node))
        return true;
    for (unsigned i = 0; i < part->child_count; i++)
        if (is_in_header(facts, part->children[i], node))
            return true;
    return false;
}

static void check_ahead(unverified_reads *s, const ir_node *node, bool as_address) {
    if (!is_in_header(s->plan->facts, s->plan->facts->loop, node)) {
        if (as_address)
            check_row(s, node, (control){false, true});
        else
            unverified_check(s, node, (control){false, true});
    }
}

/** May reads that precede the loop's own reads fail because of unverified values? These are reads
 * of keys, bases and rows before the loop, and reads that are logged before an iteration's first
 * statement. */
static bool harms_ahead(loop_plan *plan, const bool *is_suspect) {
    const loop_facts *facts = plan->facts;
    unverified_reads s = unverified_begin(plan, is_suspect, true);
    for (unsigned i = 0; i < facts->array_count; i++)
        if (!facts->arrays[i].is_scattered)
            check_ahead(&s, facts->arrays[i].base, facts->arrays[i].base->type->kind == IR_ARRAY);
    for (unsigned i = 0; i < plan->source_count; i++) {
        const loop_source *fact = plan->sources[i].fact;
        if (fact->extent != EXTENT_TOUCHED)
            check_ahead(&s, fact->row, true);
        else if (fact->base)
            check_ahead(&s, fact->base, fact->base->type->kind == IR_ARRAY);
    }
    for (unsigned i = 0; i < facts->inspector.key_count; i++)
        check_ahead(&s, facts->inspector.key[i], facts->inspector.key[i]->type->kind == IR_ARRAY);
    check_logged_at(&s, NULL, (control){false, false});
    check_logged_at(&s, facts->loop, (control){false, false});
    return s.is_harmful;
}

/* ---- all of it ----------------------------------------------------------------------------- */

static void refuse(loop_plan *plan, const bool *is_suspect) {
    const loop_facts *facts = plan->facts;
    unsigned first = 0;
    while (!is_suspect[first])
        first++;
    assert(first < facts->source_count);
    plan_obstacle(plan, facts->sources[first].row->range,
                  "'%s' may decide what the inspector reads, and may overlap an array that the "
                  "loop updates",
                  facts->sources[first].name);
}

/** May the loop write what tells its end? The dry run would then read elements that the program
 * does not read. Removes other suspects in this case. */
static bool may_move_end(const loop_facts *facts, bool *is_suspect) {
    bool is_found = false;
    if (!facts->slice.exits || !facts->slice.exits->open)
        return false;
    for (unsigned i = 0; i < facts->source_count; i++)
        is_found |= is_suspect[i] && facts->sources[i].is_subscript;
    for (unsigned i = 0; is_found && i < facts->source_count; i++)
        is_suspect[i] &= facts->sources[i].is_subscript;
    return is_found;
}

void plan_precheck(loop_plan *plan) {
    assert(plan->precheck == PRECHECK_NONE && plan->has_ready_base);
    const loop_facts *facts = plan->facts;
    bool *is_suspect = guarded_sources(plan);
    if (facts->slice.exits)
        plan->precheck = PRECHECK_OF_UPDATES;
    if (!unverified_has_suspects(plan, is_suspect))
        return;
    if (may_move_end(facts, is_suspect)) {
        refuse(plan, is_suspect);
        return;
    }
    if (harms_ahead(plan, is_suspect)) {
        refuse(plan, is_suspect);
        return;
    }
    if (!slice_is_harmed(plan, is_suspect))
        return;
    /* a pre-check of the updates covers the sources whose ranges are known before the loop */
    for (unsigned i = 0; i < facts->source_count; i++)
        is_suspect[i] &= facts->sources[i].extent == EXTENT_TOUCHED;
    plan->precheck = slice_is_harmed(plan, is_suspect) ? PRECHECK_OF_ALL : PRECHECK_OF_UPDATES;
}
