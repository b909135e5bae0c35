/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Inner loops over rows: `for (j = 0; j < n; j++) sum[k][j] += x[i][j];`. One record for the inner
 * loop contains its first element, the number of elements, and the iteration's variables that the
 * operands use. Operands are read when the record is applied. Loops with constant bounds and few
 * iterations have records with the operands' values instead (bins_nest.c), unless the array is
 * scattered.
 *
 * Why operands may be read later: before a record is applied, the guard has shown that the round's
 * reads are disjoint from its updates. The loop's other stores, to own elements, are made after all
 * iterations, and operands that read own elements are rejected. Everything else that the text names
 * is invariant in the loop, or stored in the record. A record's elements are distinct, and a bin
 * applies the record to those that lie within the bin's rows. So each element gets its updates in
 * the order of the loop, even if rows overlap.
 */
#include "analysis/base/expression.h"

#include "analysis/base/row_steps.h"
#include "analysis/base/stepped.h"
#include "ir/ir_syntax.h"
#include "plan/bins_parts.h"
#include "plan/inner_iterations.h"
#include "plan/lookup.h"
#include "plan/outline.h"
#include <assert.h>

/* ---- what the text reads ------------------------------------------------------------------- */

static bool is_private(const loop_facts *facts, const ir_variable *variable) {
    for (unsigned i = 0; i < facts->variables.private_count; i++)
        if (facts->variables.privates[i].variable == variable)
            return true;
    return variable == facts->counted.counter || ir_declarator_in(facts->counted.body, variable);
}

static bool keep_variable(const loop_plan *plan, bins_span *span, const ir_variable *variable) {
    const loop_facts *facts = plan->facts;
    const bool is_of_file = variable->storage != IR_LOCAL && variable->storage != IR_PARAMETER;
    if (variable == span->counted->counted.counter)
        return true;
    if (!is_private(facts, variable)) /* invariant */
        return (is_of_file || is_captured(facts, variable)) &&
               passing_of(plan, variable, false) != PASSED_BY_ADDRESS &&
               passing_of(plan, variable, false) != CANNOT_BE_PASSED;
    if (is_of_file)
        return false;
    for (unsigned i = 0; i < span->variable_count; i++)
        if (span->variables[i] == variable)
            return true;
    if (span->variable_count == MOST_RECORD_OPERANDS ||
        value_kind_of(variable->type) == VALUE_NONE || !variable->type->spelling)
        return false;
    span->variables[span->variable_count++] = variable;
    return true;
}

/** May this part of the update be evaluated when the record is applied? */
static bool may_be_later(const loop_plan *plan, bins_span *span, const reduction_update *update,
                         const ir_node *node) {
    if (is_updated_element(node, update->target))
        return true;
    if (node->kind == IR_CALL || node->kind == IR_OPAQUE ||
        own_element_at(plan->facts, node) >= 0 ||
        (node->type && (node->type->is_volatile || node->type->is_atomic)) ||
        (expression_written(node) && !is_updated_element(expression_written(node), update->target)))
        return false;
    if (node->kind == IR_VARIABLE)
        return keep_variable(plan, span, node->variable);
    for (unsigned i = 0; i < node->child_count; i++)
        if (!may_be_later(plan, span, update, node->children[i]))
            return false;
    return true;
}

/* ---- the loop ------------------------------------------------------------------------------ */

static bool is_named_outside(const ir_node *node, const ir_node *loop,
                             const ir_variable *variable) {
    if (node == loop)
        return false;
    if (node->kind == IR_VARIABLE && node->variable == variable)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (is_named_outside(node->children[i], loop, variable))
            return true;
    return false;
}

static bool is_only_update(const loop_facts *facts, const reduction_update *update) {
    for (unsigned i = 0; i < facts->update_count; i++)
        if (&facts->updates[i] != update && facts->updates[i].array == update->array)
            return false;
    return true;
}

/** The `for` whose body is this statement alone, or NULL if there is none. */
static const ir_node *loop_around_only(const ir_node *statement) {
    const ir_node *parent = statement->parent;
    if (parent && parent->kind == IR_BLOCK && parent->child_count == 1)
        parent = (statement = parent)->parent;
    return parent && parent->kind == IR_FOR && parent->children[3] == statement ? parent : NULL;
}

/** Does this part of the header set or declare no variable but the counter? This is required
 * because the record's values and its first element are computed before the header. */
static bool sets_only(const ir_node *node, const ir_variable *counter) {
    const ir_node *written = expression_written(node);
    if (written && (written->kind != IR_VARIABLE || written->variable != counter))
        return false;
    if (node->kind == IR_DECLARATOR && node->variable != counter)
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!sets_only(node->children[i], counter))
            return false;
    return true;
}

static bool find_span(const loop_plan *plan, const bins_plan *bins, const reduction_update *update,
                      bins_span *span) {
    const loop_facts *facts = plan->facts;
    const ir_node *loop = loop_around_only(update->statement);
    loop_span *counted = ARENA_NEW(plan->arena, loop_span);
    if (!loop || loop == facts->loop || !span_recognise((ir_node *)loop, counted))
        return false;
    *span = (bins_span){.loop = loop, .counted = counted};
    if (plan_has_leaders(plan) || counted->stepped_count != 1 || counted->counted.step != 1 ||
        counted->other_count > 0 || update->last || update->statement->kind != IR_EXPRESSION ||
        !is_only_update(facts, update) ||
        (!facts->arrays[update->array].is_scattered &&
         bins->nests[update - facts->updates].outermost))
        return false;
    const ir_variable *counter = counted->counted.counter;
    for (unsigned i = 0; i < 3; i++)
        if (loop->children[i] && !sets_only(loop->children[i], counter))
            return false;
    return counted->counted.lower && expression_constant(counted->counted.lower, &span->first) &&
           span->first >= 0 && counter->type->spelling &&
           row_stride(update->target, counter) == update->target->type->size &&
           !is_named_outside(facts->counted.body, loop, counter) &&
           syntax_editable_statement(loop, facts->counted.body) == loop &&
           may_be_later(plan, span, update, update->statement->children[0]);
}

void find_bins_spans(const loop_plan *plan, bins_plan *bins) {
    for (unsigned i = 0; i < plan->facts->update_count; i++)
        if (!find_span(plan, bins, &plan->facts->updates[i], &bins->spans[i]))
            bins->spans[i] = (bins_span){0};
}

const bins_span *span_of_stream(const bins_plan *bins, unsigned stream) {
    assert(stream < bins->stream_count);
    for (unsigned i = 0; i < bins->record_count; i++)
        if (bins->records[i].stream == stream)
            return bins->records[i].span;
    return NULL;
}
