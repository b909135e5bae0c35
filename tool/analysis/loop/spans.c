/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Inner loops that the inspector need not iterate: in the slice they only record consecutive rows,
 *
 *     for (c = 0; c < m; c++)  centers[k * m + c] += ...
 *
 * so that the first and the last row determine the range. A nested one whose header does not depend
 * on the outer one has the same rows in each of its iterations, and is recorded once:
 *
 *     for (p = first, i = 0; i < n; i++, p++)
 *         for (q = second, k = 0; k < m; k++, q++)  f[p] += ..., f[q] -= ...
 *
 * A row may go along with both if the nested loop is over constants, `f[3 * p + c]`: it has the
 * nested loop's first value in the first row and its last one in the last row.
 */
#include "analysis/loop/spans.h"

#include "analysis/base/counted.h"
#include "analysis/base/row_steps.h"
#include "analysis/base/stepped.h"

/* ---- its parts in the slice ------------------------------------------------------------------ */

static bool is_span(const loop_analysis *j, ir_node *node, loop_span *span);

/* Are the rows of the inner loop independent of the outer one's stepped variables? */
static bool stays_in(const loop_span *outer, const loop_span *inner) {
    for (unsigned i = 0; i < 3; i++)
        if (span_mentions(outer, inner->loop->children[i]) > 0)
            return false;
    return true;
}

/* `x[3 * j + c]` in a loop over a constant range of c: its ends are known. */
static bool is_vector_loop(const ir_node *loop, const loop_span *inner, const ir_node *row) {
    const ir_variable *counter;
    int64_t first, last;
    return inner->stepped_count == 1 && counted_constant(loop, &counter, &first, &last) &&
           counter == inner->counted.counter && row_steps_with(row, counter);
}

/* Is there a loop of the slice in between that also steps a variable of the row? */
static bool is_stepped_below(const loop_analysis *j, const loop_span *span, const ir_node *place,
                             const ir_node *row) {
    loop_span inner;
    for (ir_node *node = place->parent; node && node != span->loop; node = node->parent)
        if (node->kind == IR_FOR && j->slice.holds[node->id] &&
            (!span_recognise(node, &inner) ||
             (span_mentions(&inner, row) > 0 && !is_vector_loop(node, &inner, row))))
            return true;
    return false;
}

/* Is it in the slice for its counter alone, which other loops use again? */
static bool is_idle(const loop_analysis *j, const ir_node *loop) {
    const ir_variable *counter;
    int64_t first, last;
    for (unsigned i = 0; i < j->updates.count; i++)
        if (ir_contains(loop, j->updates.items[i].statement))
            return false;
    for (unsigned i = 0; i < j->sources.count; i++)
        if (j->sources.items[i].extent == EXTENT_TOUCHED && j->sources.items[i].place &&
            ir_contains(loop, j->sources.items[i].place))
            return false;
    return counted_constant(loop, &counter, &first, &last) &&
           counted_constant_sets(j->counted.body, counter);
}

/* Below, the slice has only spans, and no jumps. */
static bool is_left_out(const loop_analysis *j, const loop_span *span, ir_node *node) {
    loop_span inner;
    const bool holds = j->slice.holds[node->id];
    if (holds && node->kind == IR_FOR && is_idle(j, node))
        return is_left_out(j, span, node->children[3]);
    if (holds && node->kind == IR_FOR)
        return is_span(j, node, &inner) && stays_in(span, &inner);
    if ((holds && node->kind != IR_BLOCK) || node->kind == IR_BREAK)
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!is_left_out(j, span, node->children[i]))
            return false;
    return true;
}

static bool tells_row(const loop_analysis *j, const loop_span *span, const ir_node *place,
                      const ir_node *row) {
    return span_is_told(span, row) &&
           (span_mentions(span, row) == 0 || !is_stepped_below(j, span, place, row));
}

static bool tells_spans_only(const loop_analysis *j, const loop_span *span) {
    const ir_node *body = span->counted.body;
    unsigned count = 0;
    for (unsigned i = 0; i < j->updates.count; i++) {
        const reduction_update *update = &j->updates.items[i];
        if (!ir_contains(body, update->statement))
            continue;
        count++;
        if (!tells_row(j, span, update->statement, update->row))
            return false;
    }
    for (unsigned i = 0; i < j->sources.count; i++) {
        const loop_source *read = &j->sources.items[i];
        if (read->extent != EXTENT_TOUCHED || !read->place || !ir_contains(body, read->place))
            continue;
        count++;
        if (read->loop_count || !tells_row(j, span, read->place, read->row))
            return false;
    }
    return count > 0;
}

static bool is_span(const loop_analysis *j, ir_node *node, loop_span *span) {
    return node->kind == IR_FOR && j->slice.holds[node->id] && span_recognise(node, span) &&
           is_left_out(j, span, (ir_node *)span->counted.body) && tells_spans_only(j, span);
}

static void find_below(const loop_analysis *j, ir_node *node, span_list *spans) {
    loop_span span;
    if (is_span(j, node, &span))
        VECTOR_PUSH(j->an->memory, spans, span);
    for (unsigned i = 0; i < node->child_count; i++)
        find_below(j, node->children[i], spans);
}

span_list find_spans(const loop_analysis *j) {
    span_list spans = {0};
    for (unsigned i = 0; i < j->loop->child_count; i++)
        find_below(j, j->loop->children[i], &spans);
    return spans;
}
