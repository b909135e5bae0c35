/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/loop/executed.h"

#include <assert.h>

#include "analysis/base/expression.h"
#include "analysis/loop/place.h"
#include "analysis/loop/variation.h"

typedef VECTOR(counter_limit) limit_list;

/* Does C compare the counter and the bound as mathematical numbers, without a conversion that may
 * change one of them? */
static bool compares_numbers(const ir_type *counter, const ir_node *bound) {
    int64_t constant;
    const bool counts_signed = counter->is_signed || counter->size < 4;
    const bool is_signed = bound->type->is_signed || bound->type->size < 4;
    if (expression_constant(bound, &constant) && constant >= 0 && !counts_signed)
        return true;
    return counts_signed == is_signed;
}

static bool is_bound(const loop_analysis *j, const ir_node *bound) {
    int64_t constant;
    if (!bound->type || bound->type->kind != IR_INTEGER || !expression_is_plain(bound) ||
        !compares_numbers(j->counted.counter->type, bound))
        return false;
    if (expression_constant(bound, &constant))
        return constant > INT32_MIN && constant < INT32_MAX;
    return bound->type->size < 8 && slice_is_safe_anywhere(bound) &&
           variation_is_invariant(j->an->facts, j->loop, bound) &&
           !expression_mentions(bound, j->counted.counter);
}

static bool is_counter(const loop_analysis *j, const ir_node *node) {
    return node->kind == IR_VARIABLE && node->variable == j->counted.counter;
}

static void add_comparison(const loop_analysis *j, limit_list *list, const ir_node *condition,
                           bool holds) {
    assert(condition->kind == IR_BINARY && condition->op >= IR_OP_LESS &&
           condition->op <= IR_OP_NOT_EQUAL);
    const ir_node *left = condition->children[0], *right = condition->children[1];
    const bool is_left = is_counter(j, left);
    if (!is_left && !is_counter(j, right))
        return;
    counter_limit limit = {is_left ? condition->op : expression_mirrored(condition->op),
                           is_left ? right : left};
    if (!holds)
        limit.comparison = expression_negated(limit.comparison);
    if (is_bound(j, limit.bound))
        VECTOR_PUSH(j->an->memory, list, limit);
}

/* Adds the limits that follow from the condition being true, or false if `holds` is false. */
static void add_condition(const loop_analysis *j, limit_list *list, const ir_node *condition,
                          bool holds) {
    if (condition->kind == IR_UNARY && condition->op == IR_OP_NOT) {
        add_condition(j, list, condition->children[0], !holds);
    } else if (is_counter(j, condition)) {
        ir_node *zero = ir_new(j->an->memory, IR_NUMBER, condition->type, 0);
        zero->text = "0";
        zero->flags = IR_HAS_VALUE;
        zero->range = condition->range;
        const counter_limit limit = {holds ? IR_OP_NOT_EQUAL : IR_OP_EQUAL, zero};
        VECTOR_PUSH(j->an->memory, list, limit);
    } else if (condition->kind == IR_BINARY) {
        if (condition->op == (holds ? IR_OP_AND : IR_OP_OR)) {
            add_condition(j, list, condition->children[0], holds);
            add_condition(j, list, condition->children[1], holds);
        } else if (condition->op >= IR_OP_LESS && condition->op <= IR_OP_NOT_EQUAL) {
            add_comparison(j, list, condition, holds);
        }
    }
}

static bool is_continue(const ir_node *statement) {
    while (statement->kind == IR_BLOCK && statement->child_count == 1)
        statement = statement->children[0];
    return statement->kind == IR_CONTINUE;
}

/* Adds the limits that follow from statements such as `if (t == 0) continue;` before `below` in the
 * same block. */
static void add_jumps_above(const loop_analysis *j, limit_list *list, const ir_node *block,
                            const ir_node *below) {
    for (unsigned i = 0; i < block->child_count && block->children[i] != below; i++) {
        const ir_node *statement = block->children[i];
        if (statement->kind == IR_IF && statement->child_count == 2 &&
            is_continue(statement->children[1]))
            add_condition(j, list, statement->children[0], false);
    }
}

unsigned executed_limits(const loop_analysis *j, const ir_node *node,
                         const counter_limit **limits) {
    assert(ir_contains(j->loop, node));
    limit_list list = {0};
    for (const ir_node *below = node; below->parent && below->parent != j->loop;
         below = below->parent) {
        const ir_node *parent = below->parent;
        const bool is_chosen = (parent->kind == IR_IF || parent->kind == IR_CONDITIONAL) &&
                               parent->children[0] != below;
        if (is_chosen)
            add_condition(j, &list, parent->children[0], parent->children[1] == below);
        else if (parent->kind == IR_BINARY && parent->children[1] == below &&
                 (parent->op == IR_OP_AND || parent->op == IR_OP_OR))
            add_condition(j, &list, parent->children[0], parent->op == IR_OP_AND);
        else if (parent->kind == IR_BLOCK)
            add_jumps_above(j, &list, parent, below);
        else if (parent->kind == IR_SWITCH)
            list.count = 0; /* a jump to a label may skip the conditions found so far */
    }
    *limits = list.items;
    return list.count;
}

bool source_ends_equal(const loop_source *a, const loop_source *b) {
    if (a->limit_count != b->limit_count || a->is_sometimes != b->is_sometimes ||
        a->is_checked != b->is_checked)
        return false;
    for (unsigned i = 0; i < a->limit_count; i++)
        if (a->limits[i].comparison != b->limits[i].comparison ||
            !expression_same(a->limits[i].bound, b->limits[i].bound))
            return false;
    return true;
}

/* ---- in each iteration ----------------------------------------------------------------------- */

bool executed_certainly_in(const ir_node *outer, const ir_node *node) {
    for (; node != outer; node = node->parent)
        if (!node->parent || !expression_evaluates(node->parent, node))
            return false;
    return true;
}

/* Does `part` contain a `continue` of the loop before `node`? If `stays` is set, a `continue` that
 * stands for leaving the loop (IR_LEAVES) does not count. */
static bool is_passed_by(const ir_node *part, const ir_node *node, bool stays) {
    if (part->kind == IR_CONTINUE)
        return part->id < node->id && !(stays && part->flags & IR_LEAVES);
    if (ir_is_loop(part))
        return false;
    for (unsigned i = 0; i < part->child_count; i++)
        if (is_passed_by(part->children[i], node, stays))
            return true;
    return false;
}

static bool is_executed(const loop_analysis *j, const ir_node *node, bool stays) {
    const ir_node *body = j->counted.body;
    return ir_contains(body, node) && executed_certainly_in(body, node) &&
           !is_passed_by(body, node, stays);
}

bool executed_in_each(const loop_analysis *j, const ir_node *node) {
    return is_executed(j, node, false);
}

bool executed_in_each_staying(const loop_analysis *j, const ir_node *node) {
    return is_executed(j, node, true);
}
