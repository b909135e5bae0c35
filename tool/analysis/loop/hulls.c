/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/loop/hulls.h"

#include <assert.h>

#include "analysis/base/expression.h"
#include "analysis/base/row_steps.h"
#include "analysis/base/stepped.h"
#include "ir/ir_syntax.h"

/* A loop that may have a hull. */
typedef struct outer_loop {
    const loop_analysis *j;
    const span_list *spans;
    loop_span span;
} outer_loop;

static bool is_hull(const loop_analysis *j, const span_list *spans, const ir_node *loop);

static const loop_span *span_at(const span_list *spans, const ir_node *loop) {
    for (unsigned i = 0; i < spans->count; i++)
        if (spans->items[i].loop == loop)
            return &spans->items[i];
    return NULL;
}

/* ---- affine functions of the outer loop's counter -------------------------------------------- */

/* The value that each iteration of the outer loop's body gives a variable once. NULL if the
 * variable is declared elsewhere, or has no such single value. */
static const ir_node *value_inside(const outer_loop *t, const ir_variable *variable) {
    return ir_declarator_in(t->span.counted.body, variable)
               ? variable_single_definition(t->j->an->facts, variable)
               : NULL;
}

/* Does the expression change with the outer loop's counter? */
static bool depends(const outer_loop *t, const ir_node *node) {
    if (node->kind == IR_VARIABLE) {
        const ir_node *value = value_inside(t, node->variable);
        return node->variable == t->span.counted.counter || (value && depends(t, value));
    }
    for (unsigned i = 0; i < node->child_count; i++)
        if (depends(t, node->children[i]))
            return true;
    return false;
}

static bool is_row_affine(const outer_loop *t, const ir_node *row);

/* Is the integer or pointer an affine function of the outer loop's counter? Its arithmetic must not
 * wrap around, except as addresses do. */
static bool is_affine(const outer_loop *t, const ir_node *node) {
    if (!depends(t, node))
        return true;
    if (node->kind == IR_VARIABLE)
        return node->variable == t->span.counted.counter ||
               is_affine(t, value_inside(t, node->variable));
    if (node->kind == IR_CAST)
        return row_index_keeps_steps(node->children[0]->type, node->type) &&
               is_affine(t, node->children[0]);
    if (node->kind == IR_UNARY)
        return node->op == IR_OP_ADDRESS && is_row_affine(t, node->children[0]);
    if (node->kind != IR_BINARY ||
        !(node->type->kind == IR_POINTER || row_index_is_steady(node->type)))
        return false;
    const ir_node *left = node->children[0], *right = node->children[1];
    switch (node->op) {
    case IR_OP_MULTIPLY:
        return !(depends(t, left) && depends(t, right)) && is_affine(t, left) &&
               is_affine(t, right);
    case IR_OP_ADD:
    case IR_OP_SUBTRACT:
        return is_affine(t, left) && is_affine(t, right);
    default:
        return false;
    }
}

static bool is_row_affine(const outer_loop *t, const ir_node *row) {
    if (!depends(t, row))
        return true;
    if (row->kind == IR_MEMBER && !(row->flags & IR_ARROW))
        return is_row_affine(t, row->children[0]);
    if (row->kind != IR_INDEX || !is_affine(t, row->children[1]))
        return false;
    return ir_is_array(row->children[0]) ? is_row_affine(t, row->children[0])
                                         : is_affine(t, row->children[0]);
}

/* ---- loops ----------------------------------------------------------------------------------- */

static bool has_independent_header(const outer_loop *t, const ir_node *inner) {
    for (unsigned i = 0; i < 3; i++)
        if (depends(t, inner->children[i]))
            return false;
    return true;
}

/* Does the slice contain nothing below the node but declarations, spans, and loops with hulls whose
 * ranges are the same in each iteration? */
static bool has_only_spans(const outer_loop *t, const ir_node *node) {
    assert(node->id < t->j->function->node_count);
    const bool holds = t->j->slice.holds[node->id];
    if (holds && node->kind == IR_FOR)
        return has_independent_header(t, node) &&
               (span_at(t->spans, node) || is_hull(t->j, t->spans, node)) &&
               has_only_spans(t, node->children[3]);
    const bool is_passed =
        node->kind == IR_BLOCK || node->kind == IR_DECLARATION || node->kind == IR_DECLARATOR;
    if ((holds && !is_passed) || ir_is_jump(node))
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!has_only_spans(t, node->children[i]))
            return false;
    return true;
}

/* Does each iteration of the slice's loops inside the outer loop execute the update, and does a
 * span record it? If the program skipped iterations, the addresses for these might be invalid and
 * wrap around. */
static bool is_always_made(const outer_loop *t, const reduction_update *update) {
    assert(ir_contains(t->span.loop, update->statement));
    bool is_in_span = false;
    for (const ir_node *node = update->statement->parent; node != t->span.loop;
         node = node->parent) {
        if (node->kind != IR_BLOCK && !(node->kind == IR_FOR && t->j->slice.holds[node->id]))
            return false;
        const loop_span *span = span_at(t->spans, node);
        is_in_span |= span && span_mentions(span, update->row) > 0;
    }
    return is_in_span && update->statement->kind == IR_EXPRESSION;
}

/* Does the loop contain reads whose addresses the slice records? For a hull, they would be recorded
 * only for the first and the last iteration. */
static bool logs_reads(const loop_analysis *j, const ir_node *loop) {
    for (unsigned i = 0; i < j->sources.count; i++) {
        const loop_source *read = &j->sources.items[i];
        if (read->extent == EXTENT_TOUCHED && read->place && ir_contains(loop, read->place))
            return true;
    }
    return false;
}

static bool is_hull(const loop_analysis *j, const span_list *spans, const ir_node *loop) {
    outer_loop t = {.j = j, .spans = spans};
    const loop_span *span = &t.span;
    unsigned count = 0;
    if (loop->kind != IR_FOR || !j->slice.holds[loop->id] || span_at(spans, loop) ||
        !span_recognise((ir_node *)loop, &t.span) || span->counted.step != 1 ||
        span->stepped_count != 1 || span->other_count > 0 ||
        span->counted.counter->type->kind != IR_INTEGER || span->counted.counter->type->size < 4 ||
        ir_any(loop, ir_is_jump) || logs_reads(j, loop) || !has_only_spans(&t, span->counted.body))
        return false;
    for (unsigned i = 0; i < j->updates.count; i++) {
        const reduction_update *update = &j->updates.items[i];
        if (!ir_contains(loop, update->statement))
            continue;
        count++;
        if (!is_always_made(&t, update) || !is_row_affine(&t, update->row))
            return false;
    }
    return count > 0;
}

static void find_below(const loop_analysis *j, const span_list *spans, const ir_node *node,
                       hull_list *hulls) {
    if (is_hull(j, spans, node))
        VECTOR_PUSH(j->an->memory, hulls, node);
    for (unsigned i = 0; !ir_is_expression(node) && i < node->child_count; i++)
        find_below(j, spans, node->children[i], hulls);
}

hull_list find_hulls(const loop_analysis *j, const span_list *spans) {
    hull_list hulls = {0};
    find_below(j, spans, j->counted.body, &hulls);
    return hulls;
}
