/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/execution.h"

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
    case IR_FLOATING: /* a long double has padding bytes */
        return type->size <= 8 && type->spelling ? KEY_BYTES : KEY_UNFIT;
    default:
        return KEY_UNFIT;
    }
}

/** May a plan be kept? Only if it is known where its rows have moved. */
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

/** The stride, and variables stepped with the counter that the slice uses. */
static unsigned stepped_count(const loop_facts *facts) {
    unsigned count = facts->counted.stride ? 1 : 0;
    for (unsigned i = 0; i < facts->variables.private_count; i++)
        if (facts->variables.privates[i].is_stepped && facts->variables.privates[i].is_in_slice)
            count +=
                facts->variables.privates[i].by || facts->variables.privates[i].turns.loop ? 2 : 1;
    return count;
}

static bool has_values_beside(const loop_facts *facts) {
    return facts->scalar_count > 0 || has_conditional_live_outs(facts);
}

/** Effects of an iteration other than its updates are needed even if it makes no update. */
static bool needs_every_iteration(const loop_facts *facts) {
    return has_values_beside(facts) || facts->variables.own_count > 0 || facts->sets_errno;
}

static bool needs_order(const loop_facts *facts) {
    if (has_values_beside(facts))
        return true;
    for (unsigned i = 0; i < facts->array_count; i++)
        if (facts->arrays[i].order_is_kept)
            return true;
    return false;
}

void plan_execution(loop_plan *plan) {
    const loop_facts *facts = plan->facts;
    const bool keeps_plan = is_verifiable(plan);
    plan->execution = (execution_plan){
        .keeps_plan = keeps_plan,
        .key_count = 1 + (keeps_plan ? facts->inspector.key_count + stepped_count(facts) : 0),
        .needs_order = needs_order(facts),
        .needs_every_iteration = needs_every_iteration(facts),
        .work = work_of_iteration(plan)};
}
