/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds records that the same statements can apply: updates that differ only in rows and values.
 */
#include <assert.h>
#include <string.h>

#include "ir/ir_syntax.h"
#include "plan/bins_parts.h"

/** An update and its record. Two updates are alike if they differ only in how they name the element
 *  and the operands. */
typedef struct record_update {
    const bins_record *record;
    const reduction_update *update;
} record_update;

static bool texts_are_equal(const char *a, const char *b) {
    return a == b || (a && b && strcmp(a, b) == 0);
}

static bool leaves_are_equal(const ir_node *a, const ir_node *b) {
    if (a->kind == IR_NUMBER)
        return texts_are_equal(a->text, b->text) && ir_type_equal(a->type, b->type);
    if (a->kind == IR_CAST)
        return texts_are_equal(a->type->spelling, b->type->spelling);
    if (a->kind == IR_SIZEOF)
        return a->value == b->value && ir_type_equal(a->type, b->type);
    return a->variable == b->variable && a->function == b->function && a->field == b->field &&
           (!ir_is_expression(a) || texts_are_equal(a->text, b->text));
}

static bool are_equal_in_records(record_update left, const ir_node *a, record_update right,
                                 const ir_node *b) {
    if (ir_is_expression(a) && ir_is_expression(b)) {
        const bool is_element = is_updated_element(a, left.update->target);
        if (is_element || is_updated_element(b, right.update->target))
            return is_element && is_updated_element(b, right.update->target);
        const int number = operand_number(left.record, a);
        if (number >= 0 || operand_number(right.record, b) >= 0)
            return number == operand_number(right.record, b);
    }
    if (a->kind != b->kind || a->op != b->op || a->child_count != b->child_count ||
        !leaves_are_equal(a, b))
        return false;
    for (unsigned i = 0; i < a->child_count; i++)
        if (!are_equal_in_records(left, a->children[i], right, b->children[i]))
            return false;
    return true;
}

bool records_are_alike(const loop_facts *facts, const bins_plan *bins, const bins_record *a,
                       const bins_record *b) {
    assert(a->stream == b->stream);
    const unsigned parts = nest_part_count(a->nest);
    if (a->update_count != b->update_count || parts != nest_part_count(b->nest))
        return false;
    for (unsigned i = 0; i < a->update_count; i++) {
        const record_update left = {a, a->updates[i]}, right = {b, b->updates[i]};
        if (left.update->array != right.update->array ||
            !are_equal_in_records(left, left.update->statement, right, right.update->statement))
            return false;
        for (unsigned part = 0; part < parts && is_wide_row(facts, bins, left.update->array);
             part++)
            if (part_of_row(facts, bins, left.update, part) !=
                part_of_row(facts, bins, right.update, part))
                return false;
    }
    return true;
}
