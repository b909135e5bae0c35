/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Short loops inside a body, which the compiler should unroll (REDCC_UNROLLED), since gcc does not
 * do so at -O2. Subscripts and signs that follow from their counters then become constants, and
 * elements of arrays of vectors stay in registers. At -O2 the pragma reduced the time to assemble a
 * cloth's forces, with lanes, by a third (script/bench lanes).
 */
#include "plan/unroll.h"

#include <string.h>

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "analysis/base/loop_text.h"
#include "ir/ir_syntax.h"

enum {
    MOST_ITERATIONS = 16, /* as in REDCC_UNROLLED of redcc/loop.h */
    /* numbers of nodes of the tree (IR), after unrolling: */
    MOST_COMPUTED = 12000,   /* a triangle's force derivatives, 9 blocks of 3 x 3, have 11,700 */
    MOST_LANE_UPDATES = 600, /* one such block; more is slow to compile, and hardly faster */
    MOST_BODY = 300          /* such a body is compiled twice: with owner checks and without */
};

/** Returns the greatest number of iterations that the loop may have according to its text and that
 * of the loops around it. Returns 0 if it is unknown or exceeds MOST_ITERATIONS. */
static int64_t few_iterations(const ir_node *loop) {
    const ir_variable *counter;
    int64_t first, last, other;
    if (loop->kind != IR_FOR)
        return 0;
    if (!counted_constant(loop, &counter, &first, &last)) {
        const counted_result r = counted_recognise((ir_node *)loop);
        if (!r.is_counted || !r.loop.lower)
            return 0;
        const ir_node *low = r.loop.step > 0 ? r.loop.lower : r.loop.bound;
        const ir_node *high = r.loop.step > 0 ? r.loop.bound : r.loop.lower;
        if (!counted_range(low, &first, &other) || !counted_range(high, &other, &last))
            return 0;
        last -= r.loop.comparison == IR_OP_LESS || r.loop.comparison == IR_OP_GREATER;
    }
    const int64_t iterations = last - first + 1;
    return iterations > 0 && iterations <= MOST_ITERATIONS ? iterations : 0;
}

/** Returns the number of nodes after all short loops below the node are unrolled and called
 *  functions are inlined. Counting stops above `most`. */
static int64_t unrolled_size(const ir_node *node, int64_t most) {
    int64_t size = 1;
    const bool is_call = node->kind == IR_CALL && node->children[0]->kind == IR_FUNCTION;
    if (is_call && node->children[0]->function->body)
        size += unrolled_size(node->children[0]->function->body, most - size);
    for (unsigned i = 0; i < node->child_count && size <= most; i++)
        size += unrolled_size(node->children[i], most - size);
    const int64_t iterations = few_iterations(node);
    return iterations > 0 && size <= most ? iterations * size : size;
}

static bool header_mentions(const ir_node *loop, const ir_variable *variable) {
    for (unsigned i = 0; i < 3; i++)
        if (expression_mentions(loop->children[i], variable))
            return true;
    return false;
}

static bool has_at_most(const ir_node *loop, int64_t most) {
    const int64_t iterations = few_iterations(loop);
    if (iterations == 0 || iterations * unrolled_size(loop->children[3], most) > most)
        return false;
    /* the loop's trip count must be constant in each copy of the loops around it */
    for (const ir_node *around = loop->parent; around; around = around->parent) {
        const ir_variable *counter;
        int64_t first, last;
        if (around->kind == IR_FOR && counted_constant(around, &counter, &first, &last) &&
            header_mentions(loop, counter) && !has_at_most(around, most))
            return false;
    }
    return true;
}

bool is_unrolled_computation(const ir_node *loop) {
    return has_at_most(loop, MOST_COMPUTED);
}

bool is_unrolled_lane_update(const ir_node *loop) {
    return has_at_most(loop, MOST_LANE_UPDATES);
}

bool is_unrolled_in_body(const ir_node *loop) {
    return has_at_most(loop, MOST_BODY);
}

/** May an attribute, [[...]] or __attribute__((...)), end right before the node? A comment that
 * ends in such a bracket counts as one. */
static bool has_attribute(const char *text, const ir_node *node) {
    uint32_t at = node->range.begin;
    while (at > 0 && strchr(" \t\r\n", text[at - 1]))
        at--;
    return at > 0 &&
           (text[at - 1] == ']' || (text[at - 1] == ')' && node->parent->kind == IR_BLOCK));
}

bool takes_pragma(const loop_plan *plan, const ir_node *node) {
    const char *const text = plan->unit->source->text, *const at = text + node->range.begin;
    const ir_kind parent = node->parent->kind;
    return (parent == IR_BLOCK || parent == IR_FOR || parent == IR_IF) &&
           source_starts_with(at, "for") && !source_is_name_byte(at[strlen("for")]) &&
           loop_text_begin(plan->whole, node) == node->range.begin && !has_attribute(text, node) &&
           syntax_editable_statement(node, plan->facts->counted.body) == node;
}
