/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The inspector reads before the loop what the loop reads in its course: in
 *
 *     h[s[t]] += f(t);
 *     g[map[k[t]]] += 1;
 *
 * map[k[t]] with the k[t] of before the loop. Where k overlaps h the guard finds that out, but k[t]
 * may be no subscript of map until an earlier iteration has made it one. So, where the analysis
 * cannot tell them apart and stale values would do harm (stale.h), the runtime has all iterations
 * told once in order by one thread, a dry run, before anything else: it ends at the first update of
 * what the loop reads, as far as that is known, or read of what it has updated. Up to there nothing
 * is stale. What is read before the first iteration has no such guard: the loop is left alone.
 */
#include "emit/dry_run.h"

#include "analysis/base/expression.h"
#include "emit/slice.h"
#include "emit/stale.h"
#include "emit/syntax.h"
#include "emit/tell.h"
#include "emit/values.h"

/* ---- the slice ----------------------------------------------------------------------------- */

/** What is needed for &row. */
static void check_row(staleness *s, const ir_node *row, control how) {
    if (row->kind == IR_VARIABLE)
        return;
    if (!expression_is_lvalue(row)) {
        stale_check(s, row, how);
        return;
    }
    const ir_node *first = row->children[0];
    if (first->type && first->type->kind == IR_POINTER)
        stale_check(s, first, how);
    else
        check_row(s, first, how);
    if (row->kind == IR_INDEX)
        stale_check(s, row->children[1], how);
}

static void check_source(staleness *s, const loop_source *read, control how) {
    for (unsigned i = 0; i < read->loop_count; i++) {
        stale_check(s, read->loops[i].lower, how);
        stale_check(s, read->loops[i].bound, how);
        s->is_harmful |=
            stale_value(s, read->loops[i].lower) || stale_value(s, read->loops[i].bound);
    }
    check_row(s, read->row, how);
}

static bool is_told(const loop_text *loop, unsigned number) {
    return loop->facts->sources[number].extent == EXTENT_TOUCHED &&
           loop->source_number[number] != SOURCE_NOT_TOLD;
}

static void check_told_at(staleness *s, const ir_node *place, control how) {
    const loop_facts *facts = s->loop->facts;
    for (unsigned i = 0; i < facts->source_count; i++)
        if (is_told(s->loop, i) && facts->sources[i].place == place)
            check_source(s, &facts->sources[i], how);
}

/** True: the node makes an update, of which the slice only needs the address. */
static bool check_updates_at(staleness *s, const ir_node *node, control how) {
    const loop_facts *facts = s->loop->facts;
    bool is_update = false;
    for (unsigned i = 0; i < facts->update_count; i++)
        if (facts->updates[i].statement == node) {
            check_row(s, facts->updates[i].row, how);
            is_update = true;
        }
    const forwarded_store *store = forward_stored_by(facts, node);
    if (store && facts->slice.holds[node->id])
        stale_check(s, store->value, how);
    return is_update;
}

/** What the slice holds of the node, and what it tells there. */
static void check_held(staleness *s, const ir_node *node, control how) {
    const loop_facts *facts = s->loop->facts;
    const bool is_held = facts->slice.holds[node->id];
    how.is_stale |= s->may_have_left;
    check_told_at(s, node, how);
    if (check_updates_at(s, node, how))
        return;
    if (node->kind == IR_EXPRESSION || node->kind == IR_DECLARATOR || node->child_count == 0) {
        if (is_held)
            stale_check(s, node, how);
        return;
    }
    if (is_held && ir_is_loop(node) && !span_of(facts, node))
        s->is_harmful |= stale_condition(s, node);
    for (unsigned i = 0; i < node->child_count; i++) {
        const ir_node *child = node->children[i];
        const control below = is_held ? stale_below(s, node, how, i == 0) : how;
        if (child->kind >= IR_BLOCK)
            check_held(s, child, below);
        else if (is_held)
            stale_check(s, child, below);
    }
}

static bool slice_is_harmed(loop_text *loop, const bool *is_suspect) {
    if (!stale_has_suspects(loop, is_suspect))
        return false;
    staleness s = stale_begin(loop, is_suspect, true);
    check_held(&s, loop->facts->counted.body, stale_in_iteration(loop));
    return s.is_harmful;
}

/* ---- what is evaluated before the first iteration ------------------------------------------ */

/** The header evaluates it before anything is written. */
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

static void check_ahead(staleness *s, const ir_node *node, bool as_address) {
    if (!is_in_header(s->loop->facts, s->loop->facts->loop, node)) {
        if (as_address)
            check_row(s, node, (control){false, true});
        else
            stale_check(s, node, (control){false, true});
    }
}

/** Keys, bases, and where the rows lie that are known beforehand; what an iteration tells before
 * its first statement, perhaps long before it is read. */
static bool harms_ahead(loop_text *loop, const bool *is_suspect) {
    const loop_facts *facts = loop->facts;
    staleness s = stale_begin(loop, is_suspect, true);
    for (unsigned i = 0; i < facts->array_count; i++)
        if (!facts->arrays[i].is_scattered)
            check_ahead(&s, facts->arrays[i].base, facts->arrays[i].base->type->kind == IR_ARRAY);
    for (unsigned i = 0; i < loop->source_count; i++) {
        const loop_source *fact = loop->sources[i].fact;
        if (fact->extent != EXTENT_TOUCHED)
            check_ahead(&s, fact->row, true);
        else if (fact->base)
            check_ahead(&s, fact->base, fact->base->type->kind == IR_ARRAY);
    }
    for (unsigned i = 0; i < facts->inspector.key_count; i++)
        check_ahead(&s, facts->inspector.key[i], facts->inspector.key[i]->type->kind == IR_ARRAY);
    check_told_at(&s, NULL, (control){false, false});
    check_told_at(&s, facts->loop, (control){false, false});
    return s.is_harmful;
}

/* ---- all of it ----------------------------------------------------------------------------- */

static void refuse(loop_text *loop, const bool *is_suspect) {
    const loop_facts *facts = loop->facts;
    unsigned first = 0;
    while (!is_suspect[first])
        first++;
    loop_obstacle(loop, facts->sources[first].row->range,
                  "'%s' may decide what the inspector reads, and may overlap an array that the "
                  "loop updates",
                  facts->sources[first].name);
}

void check_stale_slice(loop_text *loop) {
    const loop_facts *facts = loop->facts;
    bool *is_suspect = guarded_sources(loop);
    if (!stale_has_suspects(loop, is_suspect))
        return;
    if (harms_ahead(loop, is_suspect)) {
        refuse(loop, is_suspect);
        return;
    }
    if (!slice_is_harmed(loop, is_suspect))
        return;
    /* what is known beforehand is seen to by a dry run of the updates */
    for (unsigned i = 0; i < facts->source_count; i++)
        is_suspect[i] &= facts->sources[i].extent == EXTENT_TOUCHED;
    loop->dry_run = slice_is_harmed(loop, is_suspect) ? DRY_RUN_OF_ALL : DRY_RUN_OF_UPDATES;
}
