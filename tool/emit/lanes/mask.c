/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Code for some lanes only: conditions as masks, and the statements under them. Memory is read only
 * in active lanes, and a select keeps a variable's old value in inactive lanes.
 */
#include "emit/lanes/vectoriser.h"

#include "emit/text/origin.h"
#include "ir/ir_words.h"
#include <assert.h>

const char *lane_masked(vectoriser *l, const ir_node *node, const char *text) {
    if (!l->mask || lane_is_safe(&l->in, node))
        return text;
    return arena_format(l->loop->arena, "(%s[redcc__l] ? %s : 0)", l->mask, text);
}

bool lane_needs_select(const vectoriser *l, const ir_variable *variable) {
    return l->mask && l->region && !ir_declarator_in(l->region, variable);
}

const char *lane_new_mask(vectoriser *l, const char *condition) {
    arena *a = l->loop->arena;
    const char *name = arena_format(a, "redcc__m%u", ++*l->mask_count);
    writer_line(l->out, "const redcc_mask %s = %s%s%s;", name, l->mask ? l->mask : "",
                l->mask ? " & " : "", condition);
    return name;
}

/** The mask of && or ||. A lane whose left operand decides the result does not evaluate the right
 * one. */
static const char *both(vectoriser *l, const ir_node *node) {
    arena *a = l->loop->arena;
    const bool is_and = node->op == IR_OP_AND;
    const char *left = lane_mask(l, node->children[0]);
    const char *const outer = l->mask;
    const bool outer_may_be_none = l->may_be_none;
    if (!lane_is_safe(&l->in, node->children[1])) {
        if (!lane_is_plain(node->children[1]))
            lane_problem(&l->in, NO_LANES_CONDITION, node->children[1]);
        l->mask = lane_new_mask(l, is_and ? left : arena_format(a, "~%s", left));
        l->may_be_none = true;
    }
    const char *right = lane_mask(l, node->children[1]);
    l->mask = outer;
    l->may_be_none = outer_may_be_none;
    return arena_format(a, "(%s %s %s)", left, is_and ? "&" : "|", right);
}

const char *lane_mask(vectoriser *l, const ir_node *node) {
    arena *a = l->loop->arena;
    if (node->kind == IR_VARIABLE && l->in.class_of[node->variable->id] == LANE_MASK)
        return origin_variable(a, node->variable);
    if (node->kind == IR_UNARY && node->op == IR_OP_NOT && lane_mentions_vector(&l->in, node))
        return arena_format(a, "(~%s)", lane_mask(l, node->children[0]));
    if (node->kind == IR_BINARY && (node->op == IR_OP_AND || node->op == IR_OP_OR) &&
        lane_mentions_vector(&l->in, node))
        return both(l, node);
    const bool is_comparison =
        node->kind == IR_BINARY && node->op >= IR_OP_LESS && node->op <= IR_OP_NOT_EQUAL;
    const ir_type *type =
        is_comparison ? lane_common(node->children[0]->type, node->children[1]->type) : NULL;
    if (type)
        return arena_format(a, "%s(%s %s %s)", lane_words_of(type)->mask,
                            lane_vector(l, node->children[0], type), ir_operator_spelling(node->op),
                            lane_vector(l, node->children[1], type));
    if (lane_is_plain(node) && !lane_mentions_vector(&l->in, node))
        return arena_format(a, "REDCC_MASK(%s)", lane_masked(l, node, lane_scalar(l, node)));
    lane_problem(&l->in, NO_LANES_CONDITION, node);
    return "0";
}

static void write_branch(vectoriser *l, const ir_node *branch, const char *mask) {
    const char *const outer_mask = l->mask;
    const ir_node *const outer_region = l->region;
    l->mask = mask;
    l->region = branch;
    writer_line(l->out, "if (redcc_any(%s)) {", mask);
    lane_part(l, branch);
    l->mask = outer_mask;
    l->region = outer_region;
}

void lane_masked_if(vectoriser *l, const ir_node *node) {
    assert(node->kind == IR_IF);
    const char *mask = lane_new_mask(l, lane_mask(l, node->children[0]));
    write_branch(l, node->children[1], mask);
    if (node->child_count > 2)
        write_branch(l, node->children[2],
                     lane_new_mask(l, arena_format(l->loop->arena, "~%s", mask)));
}
