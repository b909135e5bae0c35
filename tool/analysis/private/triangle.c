/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/private/triangle.h"

#include <assert.h>

#include "analysis/base/counted.h"
#include "analysis/base/counted_stride.h"
#include "analysis/base/expression.h"
#include "analysis/loop/executed.h"

static bool may_skip_iterations(const ir_node *body) {
    return ir_has_kind(body, IR_BREAK) || ir_has_kind(body, IR_CONTINUE) ||
           ir_has_kind(body, IR_RETURN) || ir_has_kind(body, IR_GOTO) ||
           ir_has_kind(body, IR_LABEL) || ir_has_kind(body, IR_OPAQUE) ||
           ir_has_kind(body, IR_CASE) || ir_has_kind(body, IR_DEFAULT);
}

/* Is it `i` or `i + c` for the counter i, which is `row`? Stores c, or 0, in *offset. An unsigned
 * sum is permitted only with `c = 1`, which does not wrap around, because the counter itself
 * reaches `i + 1`. */
static bool is_row_plus(const ir_variable *row, const ir_node *node, int64_t *offset) {
    assert(row->type->kind == IR_INTEGER);
    *offset = 0;
    if (expression_is_variable(node, row))
        return true;
    if (node->kind != IR_BINARY || node->op != IR_OP_ADD || !ir_type_equal(node->type, row->type))
        return false;
    for (unsigned i = 0; i < 2; i++)
        if (expression_is_variable(node->children[i], row) &&
            expression_constant(node->children[1 - i], offset))
            return *offset >= 0 && *offset <= (row->type->is_signed ? INT32_MAX : 1);
    return false;
}

static bool is_number(const ir_type *type) {
    return ir_type_is_plain_integer(type) && type->size >= 4;
}

/* Is it an end of the counter's range, and does converting it to the counter's type preserve its
 * value? */
static bool is_plain_end(const ir_node *end, const ir_type *counter, bool is_first) {
    int64_t constant;
    if (expression_constant(end, &constant))
        return constant >= 0 && constant <= INT32_MAX;
    return is_number(end->type) && end->type->is_signed == counter->is_signed &&
           (end->type->size == counter->size || (counter->is_signed && !is_first));
}

/* Recognises the inner loop. Both counters must have the same type, so that both count the same
 * numbers. */
static bool recognise(const loop_analysis *j, ir_node *loop, triangle *it) {
    const ir_variable *row = j->counted.counter;
    const counted_result result = counted_recognise_with_others(loop);
    const counted_loop *inner = &result.loop;
    const bool is_inclusive = inner->comparison == IR_OP_LESS_EQUAL;
    int64_t offset;
    if (!result.is_counted || inner->step != 1 || inner->stride || inner->ahead || !inner->lower ||
        inner->start_count > 0 || inner->bound_variable ||
        !(is_inclusive || inner->comparison == IR_OP_LESS) ||
        !ir_type_equal(inner->counter->type, row->type))
        return false;
    it->loop = loop;
    it->is_below = !is_row_plus(row, inner->lower, &offset);
    if (it->is_below && !is_row_plus(row, inner->bound, &offset))
        return false;
    it->end = it->is_below ? inner->lower : inner->bound;
    it->offset = it->is_below ? offset + is_inclusive : is_inclusive - offset;
    return is_plain_end(it->end, row->type, it->is_below) && stride_is_steady(j->loop, it->end);
}

bool triangle_around(const loop_analysis *j, const ir_node *node, triangle *it) {
    const counted_loop *outer = &j->counted;
    ir_node *loop = (ir_node *)node;
    while (loop && loop != j->loop && !ir_is_loop(loop))
        loop = loop->parent;
    return loop && loop != j->loop && loop->kind == IR_FOR && j->loop->kind == IR_FOR &&
           outer->step == 1 && !outer->stride && is_number(outer->counter->type) &&
           ir_contains(outer->body, loop) && executed_in_each(j, loop) &&
           (executed_certainly_in(loop->children[2], node) ||
            executed_certainly_in(loop->children[3], node)) &&
           !may_skip_iterations(loop->children[3]) && recognise(j, loop, it);
}
