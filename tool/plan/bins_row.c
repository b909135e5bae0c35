/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The rows of an array in the form for in-order binning: its elements or, if adjacent elements at
 * constant distances are updated (`f[i].x`, `f[i].y`; `f[i][0]`, `f[i][1]`), the structures or
 * arrays that contain them. A row is binned as a whole: one record can name the row once and hold
 * the operands of adjacent updates of its elements.
 */
#include <assert.h>
#include <string.h>

#include "ir/ir_syntax.h"
#include "plan/bins_parts.h"
#include "plan/lookup.h"

/* With larger rows, too few of them fit the cache at a time. */
enum { MOST_ROW_BYTES = 1024 };

static int64_t element_size(const loop_facts *facts, unsigned array) {
    assert(array < facts->array_count);
    return facts->arrays[array].element->size;
}

/** Is each value of the counter a valid subscript of the array? */
static bool is_within(const struct nest_level *level, const ir_type *array) {
    return level->first + level->trip <= array->count;
}

/** Is the node a part of the array or record in its first child, at an offset that is constant or
 * determined by a counter of the nest? If the offset is constant, adds it to *offset. */
static bool is_known_part(const bins_nest *nest, const ir_node *node, int64_t *offset) {
    const ir_node *whole = node->child_count > 0 ? node->children[0] : NULL;
    if (!whole || !whole->type || whole->type->size <= 0)
        return false;
    if (node->kind == IR_MEMBER && !(node->flags & IR_ARROW)) {
        *offset += node->field->offset;
        return !node->field->is_bit_field && node->field->offset >= 0;
    }
    if (node->kind != IR_INDEX || whole->type->kind != IR_ARRAY)
        return false;
    const ir_node *subscript = node->children[1];
    const struct nest_level *level = nest_level_of(nest, subscript);
    if (level)
        return is_within(level, whole->type);
    *offset += (subscript->flags & IR_HAS_VALUE) ? subscript->value * node->type->size : 0;
    return (subscript->flags & IR_HAS_VALUE) && subscript->value >= 0 &&
           subscript->value < whole->type->count;
}

const ir_node *outermost_row(const loop_facts *facts, const reduction_update *update,
                             const bins_nest *nest) {
    const ir_node *row = update->target;
    int64_t offset = 0;
    while (loop_array_of_base(facts, row) < 0 &&
           loop_array_of_base(facts, row->children[0]) != (int)update->array &&
           is_known_part(nest, row, &offset))
        row = row->children[0];
    return row;
}

/** Does the loop update two different elements of one row of the array, or update the array in a
 * nest? */
static bool has_neighbours(const loop_facts *facts, const bins_plan *bins, unsigned array) {
    for (unsigned i = 0; i < facts->update_count; i++) {
        if (facts->updates[i].array == array && nest_at(bins, i))
            return true;
        for (unsigned j = 0; j < i && facts->updates[i].array == array; j++)
            if (facts->updates[j].array == array &&
                !syntax_same(facts->updates[i].target, facts->updates[j].target) &&
                syntax_same(outermost_row(facts, &facts->updates[i], NULL),
                            outermost_row(facts, &facts->updates[j], NULL)))
                return true;
    }
    return false;
}

/** Returns the size of a row, if a row has several updated elements, and the size is not too large
 *  and is the same for all updates of the array. Otherwise returns an element's size. */
static int64_t wide_row(const loop_facts *facts, const bins_plan *bins, unsigned array) {
    const int64_t size = element_size(facts, array);
    int64_t bytes = 0;
    for (unsigned i = 0; i < facts->update_count; i++) {
        if (facts->updates[i].array != array)
            continue;
        const int64_t its = outermost_row(facts, &facts->updates[i], nest_at(bins, i))->type->size;
        if (bytes > 0 && its != bytes)
            return size;
        bytes = its;
    }
    return bytes > size && bytes <= MOST_ROW_BYTES && bytes % size == 0 &&
                   has_neighbours(facts, bins, array)
               ? bytes
               : size;
}

void find_rows(const loop_facts *facts, bins_plan *bins, bool wide) {
    for (unsigned array = 0; array < facts->array_count; array++)
        bins->row_bytes[array] = wide && !facts->arrays[array].is_scattered
                                     ? wide_row(facts, bins, array)
                                     : element_size(facts, array);
}

bool is_wide_row(const loop_facts *facts, const bins_plan *bins, unsigned array) {
    assert(array < facts->array_count);
    return bins->row_bytes[array] > element_size(facts, array);
}

const ir_node *row_in_bins(const loop_facts *facts, const bins_plan *bins,
                           const reduction_update *update, int64_t *offset) {
    *offset = 0;
    const ir_node *row = update->target;
    if (is_wide_row(facts, bins, update->array))
        for (; row->type->size != bins->row_bytes[update->array]; row = row->children[0])
            (void)is_known_part(nest_of(facts, bins, update), row, offset);
    return row;
}

unsigned part_of_row(const loop_facts *facts, const bins_plan *bins, const reduction_update *update,
                     unsigned part) {
    const bins_nest *nest = nest_of(facts, bins, update);
    assert(part < nest_part_count(nest));
    int64_t offset;
    const ir_node *row = row_in_bins(facts, bins, update, &offset);
    for (const ir_node *node = update->target; nest && node != row; node = node->children[0]) {
        const struct nest_level *level =
            node->kind == IR_INDEX ? nest_level_of(nest, node->children[1]) : NULL;
        if (level)
            offset += nest_counter_value(nest, level, part) * node->type->size;
    }
    assert(offset >= 0 && offset < bins->row_bytes[update->array]);
    return (unsigned)(offset / element_size(facts, update->array));
}

/** Has the path from the element reached the array's base or, in a scattered array, the pointer to
 *  the row? */
static bool is_row_reached(const loop_facts *facts, const reduction_update *update,
                           const ir_node *node) {
    return facts->arrays[update->array].is_scattered
               ? node->child_count == 0 || (node->type && node->type->kind == IR_POINTER)
               : loop_array_of_base(facts, node) == (int)update->array;
}

/** Does the element have its type's alignment? A member of a packed record may lack it. */
static bool is_aligned(const loop_facts *facts, const reduction_update *update) {
    const int64_t most = _Alignof(struct { double d; }), size = update->target->type->size;
    const ir_node *node = update->target;
    for (; !is_row_reached(facts, update, node); node = node->children[0]) {
        if (node->kind != IR_MEMBER)
            continue;
        const ir_type *whole = node->children[0]->type;
        whole = node->flags & IR_ARROW ? whole->target : whole;
        if (!whole->record || (whole->record->alignment > 0 &&
                               whole->record->alignment < (size < most ? size : most)))
            return false;
    }
    return true;
}

bool is_in_step(const loop_facts *facts, const bins_plan *bins, const reduction_update *update) {
    const int64_t size = bins->row_bytes[update->array];
    assert(size > 0);
    int64_t offset;
    const ir_node *node = row_in_bins(facts, bins, update, &offset);
    if (!ir_type_equal(update->target->type, facts->arrays[update->array].element) ||
        offset % element_size(facts, update->array) != 0 || !is_aligned(facts, update))
        return false;
    if (facts->arrays[update->array].is_scattered)
        return true;
    for (; loop_array_of_base(facts, node) != (int)update->array; node = node->children[0]) {
        const bool is_step = node->kind == IR_INDEX || node->kind == IR_MEMBER ||
                             (node->kind == IR_UNARY && node->op == IR_OP_DEREFERENCE);
        if (!is_step || node->type->size <= 0 || node->type->size % size != 0 ||
            (node->kind == IR_MEMBER &&
             (node->field->offset < 0 || node->field->offset % size != 0)))
            return false;
    }
    return true;
}

bool is_same_row(const loop_facts *facts, const bins_plan *bins, const reduction_update *a,
                 const reduction_update *b) {
    const int64_t size = bins->row_bytes[a->array], other_size = bins->row_bytes[b->array];
    int64_t offset;
    const ir_node *left = row_in_bins(facts, bins, a, &offset);
    const ir_node *right = row_in_bins(facts, bins, b, &offset);
    for (;; left = left->children[0], right = right->children[0]) {
        const bool ends = loop_array_of_base(facts, left) == (int)a->array;
        if (ends || loop_array_of_base(facts, right) == (int)b->array)
            return ends && loop_array_of_base(facts, right) == (int)b->array;
        if (left->kind != right->kind || left->child_count == 0 || right->child_count == 0)
            return false;
        if (left->kind == IR_INDEX && (left->type->size / size != right->type->size / other_size ||
                                       !syntax_same(left->children[1], right->children[1])))
            return false;
        if (left->kind == IR_MEMBER &&
            left->field->offset / size != right->field->offset / other_size)
            return false;
    }
}
