/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/lookup.h"

#include <assert.h>

#include "analysis/base/expression.h"
#include "ir/ir_syntax.h"

int loop_array_of_base(const loop_facts *facts, const ir_node *node) {
    for (unsigned i = 0; i < facts->array_count; i++)
        if (!facts->arrays[i].is_scattered && syntax_same(facts->arrays[i].base, node))
            return (int)i;
    return -1;
}

const reduction_update *loop_update_at(const loop_facts *facts, const ir_node *statement) {
    for (unsigned i = 0; i < facts->update_count; i++)
        if (facts->updates[i].statement == statement)
            return &facts->updates[i];
    return NULL;
}

const forwarded_store *forward_stored_by(const loop_facts *facts, const ir_node *statement) {
    for (unsigned i = 0; i < facts->forward_count; i++)
        if (facts->forwards[i].statement == statement)
            return &facts->forwards[i];
    return NULL;
}

int own_element_at(const loop_facts *facts, const ir_node *node) {
    for (unsigned i = 0; i < facts->variables.own_count; i++)
        if (expression_same(node, facts->variables.own[i].element))
            return (int)i;
    return -1;
}

int scalar_update_at(const loop_facts *facts, const ir_node *statement) {
    for (unsigned i = 0; i < facts->scalar_count; i++)
        if (facts->scalars[i].statement == statement)
            return (int)i;
    return -1;
}

const loop_span *span_of(const loop_facts *facts, const ir_node *loop) {
    for (unsigned i = 0; i < facts->inspector.span_count; i++)
        if (facts->inspector.spans[i].loop == loop)
            return &facts->inspector.spans[i];
    return NULL;
}

bool has_hull(const loop_facts *facts, const ir_node *loop) {
    for (unsigned i = 0; i < facts->inspector.hull_count; i++)
        if (facts->inspector.hulls[i] == loop)
            return true;
    return false;
}

const ir_node *body_increment(const loop_facts *facts) {
    const counted_loop *counted = &facts->counted;
    return counted->steps_inside || !ir_contains(counted->body, counted->increment)
               ? NULL
               : counted->increment;
}

/* ---- variables ----------------------------------------------------------------------------- */

bool is_declared_in(const loop_facts *facts, const ir_variable *variable) {
    for (unsigned i = 0; i < facts->variables.private_count; i++)
        if (facts->variables.privates[i].variable == variable)
            return true;
    const ir_range body = facts->counted.body->range;
    return variable->function == facts->function && variable->storage == IR_LOCAL &&
           variable->range.begin < variable->range.end && variable->range.begin >= body.begin &&
           variable->range.begin < body.end;
}

bool is_captured(const loop_facts *facts, const ir_variable *variable) {
    for (unsigned i = 0; i < facts->variables.captured_count; i++)
        if (facts->variables.captured[i] == variable)
            return true;
    return false;
}

enum { LARGEST_COPIED_RECORD = 64 };

bool is_copied_in(const ir_variable *variable) {
    const ir_type *type = variable->type;
    if (type->kind == IR_RECORD) {
        const ir_record *record = type->record;
        const ir_field *last =
            record && record->field_count > 0 ? &record->fields[record->field_count - 1] : NULL;
        const bool may_go_on = last && last->type->kind == IR_ARRAY && last->type->count <= 1;
        return type->size >= 0 && type->size <= LARGEST_COPIED_RECORD && !may_go_on &&
               !variable->address_taken;
    }
    return ir_type_is_scalar(type) || type->kind == IR_COMPLEX;
}

bool counter_outlives(const loop_facts *facts) {
    return facts->counter_is_live_after && !facts->counted.counter_is_declared_in_header;
}

bool has_live_outs(const loop_facts *facts) {
    for (unsigned i = 0; i < facts->variables.private_count; i++)
        if (facts->variables.privates[i].is_live_after)
            return true;
    return false;
}

bool has_series(const loop_facts *facts) {
    for (unsigned i = 0; i < facts->scalar_count; i++)
        if (facts->scalars[i].is_series)
            return true;
    return false;
}

unsigned series_of(const loop_facts *facts, unsigned number) {
    assert(number < facts->scalar_count && facts->scalars[number].is_series);
    unsigned first = 0;
    while (!facts->scalars[first].is_series ||
           !expression_same(facts->scalars[first].target, facts->scalars[number].target))
        first++;
    assert(first <= number);
    return first;
}

bool has_conditional_live_outs(const loop_facts *facts) {
    for (unsigned i = 0; i < facts->variables.private_count; i++)
        if (facts->variables.privates[i].is_conditional_live_out)
            return true;
    return false;
}

bool leaves_variables(const loop_facts *facts) {
    for (unsigned i = 0; i < facts->variables.private_count; i++)
        if (facts->variables.privates[i].is_stepped)
            return true;
    return has_live_outs(facts) || has_conditional_live_outs(facts);
}

bool leaves_values(const loop_facts *facts) {
    return facts->scalar_count > 0 || facts->variables.own_count > 0 || leaves_variables(facts);
}

int conditional_live_out_of(const loop_facts *facts, const ir_node *statement) {
    const ir_node *assignment = statement->kind == IR_EXPRESSION ? ir_child(statement, 0) : NULL;
    const ir_node *target =
        assignment && (assignment->kind == IR_ASSIGN || ir_is_increment(assignment))
            ? ir_child(assignment, 0)
            : NULL;
    for (unsigned i = 0; target && i < facts->variables.private_count; i++)
        if (facts->variables.privates[i].is_conditional_live_out && target->kind == IR_VARIABLE &&
            target->variable == facts->variables.privates[i].variable)
            return (int)i;
    return -1;
}
