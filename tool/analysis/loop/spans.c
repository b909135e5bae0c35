/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Inner loops that the inspector need not walk through: all that is left of them in the slice are
 * rows to be told, and these lie one after the other,
 *
 *     for (c = 0; c < m; c++)  centers[k * m + c] += ...
 *
 * so that the first and the last say where all of them are.
 */
#include "analysis/loop/spans.h"

#include "analysis/base/counted.h"
#include "analysis/base/row_steps.h"

/* Nothing below is in the slice, nor jumps. */
static bool is_left_out(const loop_analysis *j, const ir_node *node) {
    if ((j->slice.holds[node->id] && node->kind != IR_BLOCK) || node->kind == IR_BREAK ||
        node->kind == IR_CONTINUE)
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!is_left_out(j, node->children[i]))
            return false;
    return true;
}

static bool tells_spans_only(const loop_analysis *j, const counted_loop *loop) {
    unsigned count = 0;
    for (unsigned i = 0; i < j->updates.count; i++) {
        const reduction_update *update = &j->updates.items[i];
        if (!ir_contains(loop->body, update->statement))
            continue;
        count++;
        if (!row_steps_with(update->row, loop->counter))
            return false;
    }
    for (unsigned i = 0; i < j->sources.count; i++) {
        const loop_source *read = &j->sources.items[i];
        if (read->extent != EXTENT_TOUCHED || !read->place || !ir_contains(loop->body, read->place))
            continue;
        count++;
        if (read->loop_count || !row_steps_with(read->row, loop->counter))
            return false;
    }
    return count > 0;
}

static bool is_span(const loop_analysis *j, ir_node *node, counted_loop *loop) {
    if (node->kind != IR_FOR || !j->slice.holds[node->id])
        return false;
    const counted_result counted = counted_recognise(node);
    *loop = counted.loop;
    return counted.is_counted && loop->step == 1 &&
           (loop->comparison == IR_OP_LESS || loop->comparison == IR_OP_LESS_EQUAL) &&
           is_left_out(j, loop->body) && tells_spans_only(j, loop);
}

static void find_below(const loop_analysis *j, ir_node *node, span_list *spans) {
    loop_span span = {.loop = node};
    if (is_span(j, node, &span.counted)) {
        VECTOR_PUSH(j->an->memory, spans, span);
        return;
    }
    for (unsigned i = 0; i < node->child_count; i++)
        find_below(j, node->children[i], spans);
}

span_list find_spans(const loop_analysis *j) {
    span_list spans = {0};
    for (unsigned i = 0; i < j->loop->child_count; i++)
        find_below(j, j->loop->children[i], &spans);
    return spans;
}
