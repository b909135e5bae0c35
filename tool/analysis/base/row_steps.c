/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/row_steps.h"

#include "analysis/base/expression.h"

/* The greatest factor of a counter in a subscript such as `x[3 * i + c]` into an array of vectors.
 * The range from the first to the last element also contains elements that are not accessed, as it
 * does for arrays of structs. With a greater factor it would contain too many. */
enum { MOST_FLAT = 16 };

static int64_t if_short(int64_t steps) {
    return steps <= MOST_FLAT ? steps : 0;
}

bool row_index_is_steady(const ir_type *type) {
    return type && type->kind == IR_INTEGER && (ir_type_never_wraps(type) || type->size == 8);
}

bool row_index_keeps_steps(const ir_type *from, const ir_type *to) {
    return from && from->kind == IR_INTEGER && row_index_is_steady(to) &&
           (from->size < to->size ||
            (from->size == to->size && (to->size == 8 || from->is_signed == to->is_signed)));
}

/* Returns the amount by which the index increases, without wrapping around, when the counter
 * increases by 1. 0 if it is unknown. */
static int64_t steps_with(const ir_node *index, const ir_variable *counter) {
    if (index->kind == IR_VARIABLE)
        return index->variable == counter && counter->type->size >= 4;
    if (index->kind == IR_CAST)
        return row_index_keeps_steps(index->children[0]->type, index->type)
                   ? steps_with(index->children[0], counter)
                   : 0;
    if (index->kind != IR_BINARY || !row_index_is_steady(index->type))
        return 0;
    const ir_node *left = index->children[0], *right = index->children[1];
    int64_t factor;
    if (index->op == IR_OP_MULTIPLY)
        return expression_constant(left, &factor) && factor > 0 && factor <= MOST_FLAT
                   ? if_short(factor * steps_with(right, counter))
               : expression_constant(right, &factor) && factor > 0 && factor <= MOST_FLAT
                   ? if_short(factor * steps_with(left, counter))
                   : 0;
    if (index->op == IR_OP_ADD && !expression_mentions(left, counter))
        return steps_with(right, counter);
    return (index->op == IR_OP_ADD || index->op == IR_OP_SUBTRACT) &&
                   !expression_mentions(right, counter)
               ? steps_with(left, counter)
               : 0;
}

/* If the row is the same part of each element of an array, such as `a[i].f.x` or `a[i].v[2]`,
 * returns the element: a[i]. Otherwise returns the row itself. The range from the first of these
 * parts to the last also contains other parts. */
static const ir_node *element_around(const ir_node *row) {
    for (;; row = row->children[0]) {
        const bool is_member = row->kind == IR_MEMBER && !(row->flags & IR_ARROW) && row->field &&
                               !row->field->is_bit_field;
        const bool is_fixed = row->kind == IR_INDEX && row->children[0]->type &&
                              row->children[0]->type->kind == IR_ARRAY &&
                              (row->children[1]->flags & IR_HAS_VALUE);
        if (!is_member && !is_fixed)
            return row;
    }
}

/* Does the row consist of the element, or a part of it, that the stepped pointer points to: *p,
 * p[0] or p->x? Also true for p[c] with a constant c. */
static bool is_at_pointer(const ir_node *row, const ir_variable *pointer) {
    if (pointer->type->kind != IR_POINTER || pointer->type->target->size <= 0 ||
        !row->child_count || !expression_is_variable(row->children[0], pointer))
        return false;
    const bool is_member = row->kind == IR_MEMBER && (row->flags & IR_ARROW) && row->field &&
                           !row->field->is_bit_field;
    const bool is_element = row->kind == IR_INDEX && (row->children[1]->flags & IR_HAS_VALUE);
    return is_member || is_element || (row->kind == IR_UNARY && row->op == IR_OP_DEREFERENCE);
}

int64_t row_stride(const ir_node *row, const ir_variable *counter) {
    if (!expression_mentions(row, counter))
        return 0;
    row = element_around(row);
    if (is_at_pointer(row, counter))
        return counter->type->target->size;
    const int64_t steps = row->kind == IR_INDEX && row->type->size > 0 &&
                                  !expression_mentions(row->children[0], counter)
                              ? steps_with(row->children[1], counter)
                              : 0;
    return steps > 0 ? steps * row->type->size : -1;
}

bool row_steps_with(const ir_node *row, const ir_variable *counter) {
    return row_stride(row, counter) >= 0;
}

bool source_loop_is_span(const source_loop *loop, const ir_node *row) {
    return loop->step == 1 &&
           (loop->comparison == IR_OP_LESS || loop->comparison == IR_OP_LESS_EQUAL) &&
           expression_mentions(row, loop->counter) && row_steps_with(row, loop->counter);
}

/* Are the trees equal after the counters of `a` are replaced by those of `b`? */
static bool same_but_for_counters(const ir_node *x, const ir_node *y, unsigned count,
                                  const source_loop *a, const source_loop *b) {
    for (unsigned i = 0; x->kind == IR_VARIABLE && i < count; i++)
        if (x->variable == a[i].counter)
            return y->kind == IR_VARIABLE && y->variable == b[i].counter &&
                   ir_type_equal(x->variable->type, y->variable->type);
    const bool is_alike =
        x->kind == y->kind && x->op == y->op && x->field == y->field &&
        !((x->flags ^ y->flags) & IR_ARROW) && x->child_count == y->child_count &&
        (x->kind == IR_INDEX || x->kind == IR_MEMBER || x->kind == IR_UNARY ||
         x->kind == IR_BINARY || (x->kind == IR_CAST && ir_type_equal(x->type, y->type)));
    if (!is_alike)
        return expression_same(x, y);
    for (unsigned i = 0; i < x->child_count; i++)
        if (!same_but_for_counters(x->children[i], y->children[i], count, a, b))
            return false;
    return true;
}

/* Are the loops equal, except for their counter variables? */
static bool source_loops_equal(unsigned count, const source_loop *a, unsigned other_count,
                               const source_loop *b) {
    for (unsigned i = 0; count == other_count && i < count; i++)
        if (a[i].comparison != b[i].comparison || a[i].step != b[i].step ||
            a[i].may_end_early != b[i].may_end_early ||
            !ir_type_equal(a[i].counter->type, b[i].counter->type) ||
            !same_but_for_counters(a[i].lower, b[i].lower, i, a, b) ||
            !same_but_for_counters(a[i].bound, b[i].bound, i, a, b))
            return false;
    return count == other_count;
}

bool source_rows_equal(const loop_source *a, const loop_source *b) {
    return source_loops_equal(a->loop_count, a->loops, b->loop_count, b->loops) &&
           same_but_for_counters(a->row, b->row, a->loop_count, a->loops, b->loops);
}
