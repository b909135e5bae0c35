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
#include "analysis/base/expression.h"

/* Either no value of this type wraps around, or it does where addresses do. */
static bool is_steady(const ir_type *type) {
    return type && type->kind == IR_INTEGER &&
           ((type->is_signed && type->size >= 4) || type->size == 8);
}

static bool keeps_steps(const ir_type *from, const ir_type *to) {
    return from && from->kind == IR_INTEGER && is_steady(to) &&
           (from->size < to->size ||
            (from->size == to->size && (to->size == 8 || from->is_signed == to->is_signed)));
}

/* Does the index grow by one with the counter, which itself does not wrap around? */
static bool steps_with(const ir_node *index, const ir_variable *counter) {
    if (index->kind == IR_VARIABLE)
        return index->variable == counter && counter->type->size >= 4;
    if (index->kind == IR_CAST)
        return keeps_steps(index->children[0]->type, index->type) &&
               steps_with(index->children[0], counter);
    if (index->kind != IR_BINARY || !is_steady(index->type))
        return false;
    const ir_node *left = index->children[0], *right = index->children[1];
    if (index->op == IR_OP_ADD && !expression_mentions(left, counter))
        return steps_with(right, counter);
    return (index->op == IR_OP_ADD || index->op == IR_OP_SUBTRACT) &&
           !expression_mentions(right, counter) && steps_with(left, counter);
}

static bool is_row_of_span(const ir_node *row, const ir_variable *counter) {
    if (!expression_mentions(row, counter))
        return true;
    return row->kind == IR_INDEX && row->type->size > 0 &&
           !expression_mentions(row->children[0], counter) && steps_with(row->children[1], counter);
}

/* Nothing below is in the slice, nor jumps. */
static bool is_left_out(const judgement *j, const ir_node *node) {
    if ((j->in_slice[node->id] && node->kind != IR_BLOCK) || node->kind == IR_BREAK ||
        node->kind == IR_CONTINUE)
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!is_left_out(j, node->children[i]))
            return false;
    return true;
}

static bool tells_spans_only(const judgement *j, const counted_loop *loop) {
    unsigned count = 0;
    for (unsigned i = 0; i < j->updates.count; i++) {
        const reduction_update *update = &j->updates.items[i];
        if (!ir_contains(loop->body, update->statement))
            continue;
        count++;
        if (!is_row_of_span(update->row, loop->counter))
            return false;
    }
    for (unsigned i = 0; i < j->sources.count; i++) {
        const loop_source *read = &j->sources.items[i];
        if (read->extent != EXTENT_TOUCHED || !read->place || !ir_contains(loop->body, read->place))
            continue;
        count++;
        if (!is_row_of_span(read->row, loop->counter))
            return false;
    }
    return count > 0;
}

static bool is_span(const judgement *j, ir_node *node, counted_loop *loop) {
    if (node->kind != IR_FOR || !j->in_slice[node->id])
        return false;
    const counted_result counted = counted_recognise(node);
    *loop = counted.loop;
    return counted.is_counted && loop->step == 1 &&
           (loop->comparison == IR_OP_LESS || loop->comparison == IR_OP_LESS_EQUAL) &&
           is_left_out(j, loop->body) && tells_spans_only(j, loop);
}

static void find_below(judgement *j, ir_node *node) {
    loop_span span = {.loop = node};
    if (is_span(j, node, &span.counted)) {
        VECTOR_PUSH(j->an->memory, &j->spans, span);
        return;
    }
    for (unsigned i = 0; i < node->child_count; i++)
        find_below(j, node->children[i]);
}

void find_spans(judgement *j) {
    for (unsigned i = 0; i < j->loop->child_count; i++)
        find_below(j, j->loop->children[i]);
}
