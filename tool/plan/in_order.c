/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/in_order.h"

#include <assert.h>

#include "ir/ir_syntax.h"
#include "plan/lookup.h"

static bool mentions(const ir_node *node, const ir_node *row) {
    if (!node)
        return false;
    if (syntax_same(node, row))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (mentions(node->children[i], row))
            return true;
    return false;
}

/** The variable that contains the row, or NULL if a pointer leads to the row. */
static const ir_variable *variable_with(const ir_node *row) {
    while ((row->kind == IR_MEMBER && !(row->flags & IR_ARROW)) ||
           (row->kind == IR_INDEX && row->children[0]->type->kind == IR_ARRAY))
        row = row->children[0];
    return row->kind == IR_VARIABLE ? row->variable : NULL;
}

/** Does the executor read the row once, before the first iteration, although the sequential loop
 *  reads it in each iteration? */
static bool is_read_before(const loop_facts *facts, const ir_node *row) {
    const ir_variable *variable = variable_with(row);
    if (variable && is_captured(facts, variable) && is_copied_in(variable))
        return true;
    for (unsigned i = 0; i < facts->array_count; i++)
        if (mentions(facts->arrays[i].base, row))
            return true;
    return mentions(facts->counted.bound, row) || mentions(facts->counted.stride, row);
}

bool has_values_from_before(const loop_facts *facts) {
    for (unsigned i = 0; i < facts->source_count; i++) {
        const loop_source *read = &facts->sources[i];
        if (read->needs_guard && (read->is_scalar || own_element_at(facts, read->row) >= 0 ||
                                  is_read_before(facts, read->row)))
            return true;
    }
    return false;
}

/** Does an iteration compute values from its number (stepped variables), or does it have results
 * that are stored only after all iterations? */
static bool counts_iterations(const loop_facts *facts) {
    for (unsigned i = 0; i < facts->variables.private_count; i++)
        if (facts->variables.privates[i].is_stepped ||
            facts->variables.privates[i].is_conditional_live_out)
            return true;
    return facts->scalar_count > 0 || facts->variables.own_count > 0 || facts->distribution;
}

static bool calls_function(const ir_node *node) {
    const ir_function *callee = node->kind == IR_CALL ? ir_called_function(node) : NULL;
    return callee && callee->body;
}

bool may_begin_in_order(const loop_facts *facts) {
    assert(!has_values_from_before(facts));
    const counted_loop *counted = &facts->counted;
    const bool is_short = facts->has_short_iterations && !ir_any(counted->body, calls_function);
    return !is_short && !counts_iterations(facts) && !facts->slice.exits &&
           !facts->slice.may_abort && counted->counter->type->kind == IR_INTEGER &&
           counted->step == 1 && !counted->stride;
}
