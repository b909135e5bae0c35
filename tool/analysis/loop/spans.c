/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A span is an inner loop that the inspector need not iterate. In the slice it only records
 *  consecutive rows, so the first and the last row determine the range:
 *
 *      for (c = 0; c < m; c++) centers[k * m + c] += ...
 *
 *  A nested span whose header does not depend on the outer span has the same rows in each outer
 *  iteration, and is recorded once:
 *
 *      for (p = first, i = 0; i < n; i++, p++)
 *          for (q = second, k = 0; k < m; k++, q++) f[p] += ..., f[q] -= ...
 *
 *  A row may depend on both counters if the nested loop is over constants, as in `f[3 * p + c]`.
 *  The first row is then that for the nested loop's first value, the last row that for its last
 *  value.
 *
 *  If the loop has a step of s (here 3), each iteration must access s consecutive rows. The range
 *  then contains no others:
 *
 *      for (j = 0; j < n; j += 3) f[j] += ..., f[j + 1] += ..., f[j + 2] += ... */
#include "analysis/loop/spans.h"

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "analysis/base/row_steps.h"
#include "analysis/base/stepped.h"
#include "ir/ir_syntax.h"

/* ---- its parts in the slice ------------------------------------------------------------------ */

static bool is_span(const loop_analysis *j, ir_node *node, loop_span *span);

/* Is the inner loop's header independent of the variables that the outer loop steps? */
static bool has_independent_header(const loop_span *outer, const loop_span *inner) {
    for (unsigned i = 0; i < 3; i++)
        if (span_mentions(outer, inner->loop->children[i]) > 0)
            return false;
    return true;
}

/* Does the loop step only a counter c over a constant range, and does the row advance with c, as in
 * `x[3 * j + c]`? Its first and last rows are then known. */
static bool is_vector_loop(const ir_node *loop, const loop_span *inner, const ir_node *row) {
    const ir_variable *counter;
    int64_t first, last;
    return inner->stepped_count == 1 && counted_constant(loop, &counter, &first, &last) &&
           counter == inner->counted.counter && row_steps_with(row, counter);
}

/* Does a loop of the slice between the span and the place also step a variable of the row? */
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

/* Is the loop in the slice only because other loops reuse its counter? */
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

/* Does the slice contain nothing below the node but blocks, idle loops (is_idle), and spans with
 * headers independent of `span`? False if there is a `break`. */
static bool has_only_spans(const loop_analysis *j, const loop_span *span, ir_node *node) {
    loop_span inner;
    const bool holds = j->slice.holds[node->id];
    if (holds && node->kind == IR_FOR && is_idle(j, node))
        return has_only_spans(j, span, node->children[3]);
    if (holds && node->kind == IR_FOR)
        return is_span(j, node, &inner) && has_independent_header(span, &inner);
    if ((holds && node->kind != IR_BLOCK) || node->kind == IR_BREAK)
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!has_only_spans(j, span, node->children[i]))
            return false;
    return true;
}

static bool records_row(const loop_analysis *j, const loop_span *span, const ir_node *place,
                        const ir_node *row) {
    return span_is_recorded(span, row) &&
           (span_mentions(span, row) == 0 || !is_stepped_below(j, span, place, row));
}

/* Is `other` a different row of the same array? */
static bool is_another(const ir_node *row, const ir_node *other) {
    return other->kind == IR_INDEX && syntax_same(row->children[0], other->children[0]) &&
           !syntax_same(row->children[1], other->children[1]);
}

/* Do the span's iterations together access all rows of the range? If they skipped some, other
 * iterations of the analysed loop might update these. */
static bool has_all_rows(const loop_analysis *j, const loop_span *span, const ir_node *row,
                         bool is_update) {
    int64_t count = 1;
    if (span->counted.step == 1 || span_mentions(span, row) == 0)
        return true;
    for (unsigned i = 0; row->kind == IR_INDEX && is_update && i < j->updates.count; i++) {
        const ir_node *other = j->updates.items[i].row;
        count += ir_contains(span->counted.body, j->updates.items[i].statement) &&
                 is_another(row, other);
    }
    for (unsigned i = 0; row->kind == IR_INDEX && !is_update && i < j->sources.count; i++) {
        const loop_source *read = &j->sources.items[i];
        count += read->extent == EXTENT_TOUCHED && read->place &&
                 ir_contains(span->counted.body, read->place) && is_another(row, read->row);
    }
    return count >= span->counted.step;
}

static bool records_only_spans(const loop_analysis *j, const loop_span *span) {
    const ir_node *body = span->counted.body;
    unsigned count = 0;
    for (unsigned i = 0; i < j->updates.count; i++) {
        const reduction_update *update = &j->updates.items[i];
        if (!ir_contains(body, update->statement))
            continue;
        count++;
        if (!records_row(j, span, update->statement, update->row) ||
            !has_all_rows(j, span, update->row, true))
            return false;
    }
    for (unsigned i = 0; i < j->sources.count; i++) {
        const loop_source *read = &j->sources.items[i];
        if (read->extent != EXTENT_TOUCHED || !read->place || !ir_contains(body, read->place))
            continue;
        count++;
        if (read->loop_count || !records_row(j, span, read->place, read->row) ||
            !has_all_rows(j, span, read->row, false))
            return false;
    }
    return count > 0;
}

/* Is the statement, declarator or header that contains the expression in the slice? An expression
 * without a parent has been removed from the tree and is printed elsewhere; it counts as in the
 * slice. */
static bool is_held(const loop_analysis *j, const ir_node *node) {
    while (node && ir_is_expression(node))
        node = node->parent;
    return !node || j->slice.holds[node->id];
}

static bool is_in_loop(const loop_analysis *j, const ir_node *node) {
    return node->id > j->loop->id && node->id <= expression_last_id(j->loop);
}

/* Is the variable's value used by a recorded row, or by a part of the slice other than the span's
 * increment? */
static bool is_read_in_slice(const loop_analysis *j, const loop_span *span,
                             const ir_variable *variable) {
    const variable_fact *fact = variable_fact_of(j->an->facts, variable);
    for (unsigned i = 0; i < fact->occurrences.count; i++) {
        const ir_node *use = fact->occurrences.items[i];
        if (!expression_is_assigned(use) && is_in_loop(j, use) &&
            !ir_contains(span->loop->children[2], use) && is_held(j, use))
            return true;
    }
    for (unsigned i = 0; i < j->updates.count; i++)
        if (expression_mentions(j->updates.items[i].row, variable))
            return true;
    for (unsigned i = 0; i < j->sources.count; i++) {
        const loop_source *read = &j->sources.items[i];
        bool is_read = expression_mentions(read->row, variable);
        for (unsigned k = 0; k < read->loop_count; k++)
            is_read |= expression_mentions(read->loops[k].lower, variable) ||
                       expression_mentions(read->loops[k].bound, variable);
        if (is_read)
            return true;
    }
    return false;
}

static bool may_leave_steps_out(const loop_analysis *j, const loop_span *span) {
    for (unsigned i = 0; i < span->other_count; i++)
        if (is_read_in_slice(j, span, span->others[i]))
            return false;
    return true;
}

static bool is_span(const loop_analysis *j, ir_node *node, loop_span *span) {
    return node->kind == IR_FOR && j->slice.holds[node->id] && span_recognise(node, span) &&
           has_only_spans(j, span, (ir_node *)span->counted.body) && records_only_spans(j, span) &&
           may_leave_steps_out(j, span);
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
