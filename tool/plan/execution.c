/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/execution.h"

#include <assert.h>

#include "analysis/base/counted.h"
#include "plan/continuation.h"
#include "plan/in_order.h"
#include "plan/lookup.h"
#include "plan/work.h"

bool may_be_copied(const loop_plan *plan, const reduction_array *array) {
    const bool may_overflow = array->element->kind == IR_INTEGER && array->element->is_signed;
    return !array->is_interleaved && !array->order_is_kept &&
           !(may_overflow && plan->unit->dialect.is_sanitized);
}

/* ---- keys ---------------------------------------------------------------------------------- */

key_form form_of_key(const ir_type *type) {
    switch (type->kind) {
    case IR_BOOLEAN:
    case IR_INTEGER:
        return KEY_INTEGER;
    case IR_POINTER:
    case IR_ARRAY:
        return KEY_POINTER;
    case IR_FLOATING: /* a long double has padding bytes, so it cannot be a key */
        return type->size <= 8 && type->spelling ? KEY_BYTES : KEY_UNFIT;
    default:
        return KEY_UNFIT;
    }
}

/** May the runtime keep a plan? In a later execution the arrays that are read may have moved, so
 * the runtime must be able to read their bases before the loop. All values of the key must fit
 * into words. */
static bool is_verifiable(const loop_plan *plan) {
    const loop_facts *facts = plan->facts;
    if (!facts->slice.is_verifiable)
        return false;
    for (unsigned i = 0; i < facts->source_count; i++) {
        const loop_source *fact = &facts->sources[i];
        if (fact->extent == EXTENT_TOUCHED && fact->base && !plan->has_ready_base[i])
            return false;
    }
    for (unsigned i = 0; i < facts->inspector.key_count; i++)
        if (form_of_key(facts->inspector.key[i]->type) == KEY_UNFIT)
            return false;
    return true;
}

/** Returns the number of key words for the stride, and for stepped variables that the slice
 *  uses. */
static unsigned stepped_count(const loop_facts *facts) {
    unsigned count = facts->counted.stride ? 1 : 0;
    for (unsigned i = 0; i < facts->variables.private_count; i++)
        if (facts->variables.privates[i].is_stepped && facts->variables.privates[i].is_in_slice)
            count +=
                facts->variables.privates[i].stride_count || facts->variables.privates[i].inner.loop
                    ? 2
                    : 1;
    return count;
}

static bool has_other_results(const loop_facts *facts) {
    return facts->scalar_count > 0 || has_conditional_live_outs(facts);
}

/** Does an iteration have effects other than its updates? Then one thread must execute it even if
 * it updates nothing. */
static bool needs_every_iteration(const loop_facts *facts) {
    return has_other_results(facts) || facts->variables.own_count > 0 || facts->sets_errno;
}

bool may_be_reordered(const loop_facts *facts) {
    for (unsigned i = 0; i < facts->scalar_count; i++)
        if (facts->scalars[i].is_series)
            return false;
    for (unsigned i = 0; i < facts->array_count; i++)
        if (facts->arrays[i].order_is_kept)
            return false;
    return !has_conditional_live_outs(facts) && !facts->slice.exits;
}

static bool needs_order(const loop_facts *facts) {
    if (has_other_results(facts))
        return true;
    for (unsigned i = 0; i < facts->array_count; i++)
        if (facts->arrays[i].order_is_kept)
            return true;
    return false;
}

static bool holds_update(const loop_facts *facts, const ir_node *node) {
    for (unsigned i = 0; i < facts->update_count; i++)
        if (ir_contains(node, facts->updates[i].statement))
            return true;
    return false;
}

/** Does the slice contain calls, or loops without updates, such as searches? */
static bool has_search(const loop_facts *facts, const ir_node *node) {
    if (ir_is_expression(node))
        return ir_has_kind(node, IR_CALL);
    assert(node->id < facts->function->node_count);
    if (!facts->slice.holds[node->id])
        return false;
    if (ir_is_loop(node) && !holds_update(facts, node))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (has_search(facts, node->children[i]))
            return true;
    return false;
}

/** Returns the innermost loop around a statement of the body, or NULL if there is none. Loops with
 * constant bounds, over the components of a vector, do not count. */
static const ir_node *inner_loop_around(const loop_facts *facts, const ir_node *node) {
    assert(ir_contains(facts->loop, node));
    for (; node != facts->loop; node = node->parent) {
        const ir_variable *counter;
        int64_t first, last;
        if (ir_is_loop(node) && !counted_constant(node, &counter, &first, &last))
            return node;
    }
    return NULL;
}

/** Is inspecting an iteration short even if executing it is long? True if some updates are in inner
 * loops, and the inspector logs the rows of each of these loops as one range (loop_span). The slice
 * must contain no search, and the loop must need no pre-check (precheck.h). */
static bool is_over_blocks(const loop_plan *plan) {
    const loop_facts *facts = plan->facts;
    const ir_node *const body = facts->counted.body;
    bool has_blocks = false;
    if (!facts->inspector.exists || plan->precheck != PRECHECK_NONE || has_search(facts, body))
        return false;
    for (unsigned i = 0; i < facts->update_count; i++) {
        const ir_node *inner = inner_loop_around(facts, facts->updates[i].statement);
        if (inner && !span_of(facts, inner))
            return false;
        has_blocks |= inner != NULL;
    }
    return has_blocks;
}

/** Is each scalar with a series a variable? Reading it is then harmless, even if the loop adds
 *  nothing to it. */
static bool are_series_of_variables(const loop_facts *facts) {
    for (unsigned i = 0; i < facts->scalar_count; i++)
        if (facts->scalars[i].is_series && facts->scalars[i].target->kind != IR_VARIABLE)
            return false;
    return true;
}

/** May the first iterations be executed by owners, as long as none updates what the loop reads, and
 * the others in order (runtime/src/ownership/fences.h)? */
static bool may_end_in_order(const loop_facts *facts) {
    return facts->inspector.exists && !has_values_from_before(facts) &&
           are_series_of_variables(facts) && !facts->slice.exits && !facts->slice.may_abort;
}

void plan_execution(loop_plan *plan) {
    const loop_facts *facts = plan->facts;
    const bool keeps_plan = is_verifiable(plan), needs_whole = has_values_from_before(facts);
    plan->execution = (execution_plan){
        .keeps_plan = keeps_plan,
        .key_count = 1 + (keeps_plan ? facts->inspector.key_count + stepped_count(facts) : 0),
        .needs_order = needs_order(facts),
        .needs_every_iteration = needs_every_iteration(facts),
        .needs_whole = needs_whole,
        .may_begin = !needs_whole && may_begin_in_order(facts),
        .may_end_in_order = may_end_in_order(facts),
        .may_continue = may_continue_at_exits(facts),
        .is_over_blocks = is_over_blocks(plan),
        .work = work_of_iteration(plan),
        .order = plan->options->order};
}
