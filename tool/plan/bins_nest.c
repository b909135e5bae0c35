/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loops with constant bounds that contain only updates: `for (c = 0; c < 3; c++) f[i][c] += a[c];`.
 * Each update has one record, appended before the nest, with the operands of all iterations. Since
 * updates are applied later, this is legal only if the operands read nothing that the nest changes,
 * and if no update reaches the same element in two iterations of the nest.
 */
#include <assert.h>
#include <string.h>

#include "analysis/base/counted.h"
#include "ir/ir_syntax.h"
#include "plan/bins_parts.h"
#include "plan/lookup.h"

/* ---- the loops ----------------------------------------------------------------------------- */

/** Is this `for (c = FIRST; c < BOUND; c++)` with constant bounds, none negative, and few
 * iterations? If so, sets *level. */
static bool is_level(const ir_node *node, struct nest_level *level) {
    const ir_variable *counter;
    ir_variable *stepped;
    int64_t last, step;
    if (node->kind != IR_FOR || !counted_constant(node, &counter, &level->first, &last) ||
        !counted_step(node->children[2], &stepped, &step) || step != 1 || stepped != counter ||
        value_kind_of(counter->type) == VALUE_NONE)
        return false;
    level->counter = counter;
    level->trip = last - level->first + 1;
    return level->first >= 0 && level->trip <= MOST_RECORD_VALUES;
}

static bool holds_only_updates(const loop_facts *facts, const ir_node *node) {
    const reduction_update *update = loop_update_at(facts, node);
    struct nest_level level;
    if (update)
        return !update->last;
    if (node->kind == IR_FOR)
        return is_level(node, &level) && holds_only_updates(facts, node->children[3]);
    for (unsigned i = 0; i < node->child_count; i++)
        if (!holds_only_updates(facts, node->children[i]))
            return false;
    return node->kind == IR_BLOCK;
}

const struct nest_level *nest_level_of(const bins_nest *nest, const ir_node *node) {
    for (unsigned i = 0; nest && node->kind == IR_VARIABLE && i < nest->depth; i++)
        if (nest->levels[i].counter == node->variable)
            return &nest->levels[i];
    return NULL;
}

static bool mentions_counter(const bins_nest *nest, const ir_node *node) {
    if (nest_level_of(nest, node))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (mentions_counter(nest, node->children[i]))
            return true;
    return false;
}

unsigned nest_part_count(const bins_nest *nest) {
    unsigned count = 1;
    for (unsigned i = 0; nest && i < nest->depth; i++) {
        assert(nest->levels[i].trip > 0);
        count *= (unsigned)nest->levels[i].trip;
    }
    return count;
}

/** Does each counter occur once as a subscript of the row's parts, and nowhere else in the
 *  element's address? If so, all iterations' elements are different, and are in one row. */
static bool is_one_row(const loop_facts *facts, const reduction_update *update,
                       const bins_nest *nest) {
    const ir_node *row = outermost_row(facts, update, nest);
    unsigned found[MOST_NEST_DEPTH] = {0};
    for (const ir_node *node = update->target; node != row; node = node->children[0]) {
        const struct nest_level *level =
            node->kind == IR_INDEX ? nest_level_of(nest, node->children[1]) : NULL;
        if (level)
            found[level - nest->levels]++;
    }
    for (unsigned i = 0; i < nest->depth; i++)
        if (found[i] != 1)
            return false;
    return !mentions_counter(nest, row);
}

/** Sets *nest to the loops around the update, from `outermost` on. Returns false if they cannot be
 * a nest. */
static bool make_nest(const loop_facts *facts, const reduction_update *update,
                      const ir_node *outermost, bins_nest *nest) {
    assert(ir_contains(outermost, update->statement));
    *nest = (bins_nest){.outermost = outermost};
    if (!syntax_editable_statement(outermost, facts->counted.body))
        return false; /* a macro's expansion may contain more than the loop */
    for (const ir_node *node = outermost; node != update->statement;) {
        const ir_node *next = NULL;
        if (node->kind == IR_FOR) {
            if (nest->depth == MOST_NEST_DEPTH || !is_level(node, &nest->levels[nest->depth++]))
                return false;
            next = node->children[3];
        }
        for (unsigned i = 0; node->kind == IR_BLOCK && i < node->child_count; i++)
            if (ir_contains(node->children[i], update->statement))
                next = node->children[i];
        if (!next)
            return false;
        node = next;
    }
    return nest_part_count(nest) <= MOST_RECORD_VALUES && is_one_row(facts, update, nest);
}

/** The largest nest around the update; outermost is NULL if there is none. */
static bins_nest find_nest(const loop_facts *facts, const reduction_update *update) {
    bins_nest found = {0}, nest;
    for (const ir_node *node = update->statement->parent;
         node && node != facts->loop && (node->kind == IR_FOR || node->kind == IR_BLOCK);
         node = node->parent)
        if (node->kind == IR_FOR) {
            if (!holds_only_updates(facts, node))
                break;
            if (make_nest(facts, update, node, &nest))
                found = nest;
        }
    return found;
}

/* ---- the order of updates ------------------------------------------------------------------ */

/** Do both updates reach the same parts of their rows in each iteration of their nests? */
static bool have_equal_parts(const loop_facts *facts, const reduction_update *a,
                             const bins_nest *of_a, const reduction_update *b,
                             const bins_nest *of_b) {
    const ir_node *left = a->target, *right = b->target;
    const ir_node *const left_row = outermost_row(facts, a, of_a);
    const ir_node *const right_row = outermost_row(facts, b, of_b);
    for (; left != left_row && right != right_row;
         left = left->children[0], right = right->children[0])
        if (left->kind != right->kind ||
            (left->kind == IR_INDEX && !syntax_same(left->children[1], right->children[1])) ||
            (left->kind == IR_MEMBER && left->field != right->field))
            return false;
    return left == left_row && right == right_row;
}

/** Does each element still get its updates in the order of the loop, although the records of the
 * nest's updates are appended statement by statement? It does if the updates of one array reach
 * the same element only in the same iteration. */
static bool keeps_order(const loop_facts *facts, const bins_nest *nests, unsigned i) {
    for (unsigned j = 0; nests[i].outermost && j < facts->update_count; j++)
        if (facts->updates[j].array == facts->updates[i].array &&
            ir_contains(nests[i].outermost, facts->updates[j].statement) &&
            !have_equal_parts(facts, &facts->updates[i], &nests[i], &facts->updates[j], &nests[j]))
            return false;
    return true;
}

void find_nests(const loop_facts *facts, bins_plan *bins) {
    for (unsigned i = 0; i < facts->update_count; i++)
        bins->nests[i] = find_nest(facts, &facts->updates[i]);
    for (unsigned i = 0; i < facts->update_count; i++)
        if (!keeps_order(facts, bins->nests, i)) {
            memset(bins->nests, 0, facts->update_count * sizeof *bins->nests);
            return;
        }
}

const bins_nest *nest_at(const bins_plan *bins, unsigned i) {
    return bins->has_nests && bins->nests[i].outermost ? &bins->nests[i] : NULL;
}

const bins_nest *nest_of(const loop_facts *facts, const bins_plan *bins,
                         const reduction_update *update) {
    return is_wide_row(facts, bins, update->array)
               ? nest_at(bins, (unsigned)(update - facts->updates))
               : NULL;
}

/* ---- the counters' values ------------------------------------------------------------------ */

int64_t nest_counter_value(const bins_nest *nest, const struct nest_level *level, unsigned part) {
    assert(level >= nest->levels && level < nest->levels + nest->depth);
    assert(part < nest_part_count(nest));
    unsigned i = nest->depth - 1;
    for (; &nest->levels[i] != level; i--)
        part /= (unsigned)nest->levels[i].trip;
    return level->first + part % (unsigned)level->trip;
}
