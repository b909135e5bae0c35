/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * v = v0 + c (t - t0): where every iteration adds the same constant to v, exactly once and whatever
 * it does otherwise, each iteration can begin with a copy that has the value of the sequential loop
 * there, and execute its text as it stands. The sum is made modulo 2^64 and converted to v's type:
 * the sequential loop has the same value, where it does not overflow.
 */
#include "analysis/private/induction.h"

#include "analysis/base/expression.h"
#include "analysis/loop/executed.h"
#include "analysis/private/live.h"

static bool is_executed_once(const judgement *j, const ir_node *write) {
    if (ir_contains(j->counted.body, write))
        return executed_in_each(j, write);
    return j->loop->kind == IR_FOR && ir_contains(j->loop->children[2], write) &&
           executed_certainly_in(j->loop->children[2], write);
}

static bool is_integer(const ir_type *type) {
    return type->kind == IR_INTEGER && type->size > 0 && type->size <= 8 && !type->is_volatile &&
           !type->is_atomic;
}

static bool is_of_function(const judgement *j, const ir_variable *variable) {
    const ir_node *declarator = variable_fact_of(j->an->facts, variable)->declarator;
    return (variable->storage == IR_LOCAL || variable->storage == IR_PARAMETER) &&
           variable->function == j->function && !variable->address_taken &&
           !variable->has_other_name && !(declarator && ir_contains(j->loop, declarator));
}

/* What the header sets the variable to when the loop begins; NULL: nothing. */
static const ir_node *start_of(const judgement *j, const ir_variable *variable) {
    for (unsigned i = 0; i < j->counted.start_count; i++)
        if (j->counted.starts[i]->children[0]->variable == variable)
            return j->counted.starts[i];
    return NULL;
}

/* The sum of all steps in the loop; false: there is another write. */
static bool sum_steps(const judgement *j, const ir_variable *variable, int64_t *sum) {
    const variable_fact *fact = variable_fact_of(j->an->facts, variable);
    *sum = 0;
    for (unsigned i = 0; i < fact->writes.count; i++) {
        const ir_node *write = fact->writes.items[i];
        ir_variable *stepped;
        int64_t step;
        if (!ir_contains(j->loop, write) || write == start_of(j, variable))
            continue;
        if (!counted_step(write, &stepped, &step) || stepped != variable ||
            !is_executed_once(j, write))
            return false;
        *sum += step;
    }
    return *sum <= INT32_MAX && *sum >= -(int64_t)INT32_MAX;
}

static bool is_taken(const judgement *j, const ir_variable *variable) {
    for (unsigned i = 0; i < j->privates.count; i++)
        if (j->privates.items[i].variable == variable)
            return true;
    return false;
}

bool induction_take(judgement *j, const ir_variable *variable) {
    int64_t step;
    if (is_taken(j, variable))
        return true;
    if (!is_integer(variable->type) || !is_of_function(j, variable) ||
        !sum_steps(j, variable, &step))
        return false;
    const ir_node *start = start_of(j, variable);
    /* Where the header sets nothing the loop itself, reached once more, goes on with the value. */
    private_variable item = {.variable = (ir_variable *)variable,
                             .entry = start ? start->children[1] : NULL,
                             .is_stepped = true,
                             .step = step,
                             .is_step_wanted =
                                 !start || variable_is_live_after(j->an->facts, j->loop, variable)};
    VECTOR_PUSH(j->an->memory, &j->privates, item);
    return true;
}

static bool take_steps(judgement *j, const ir_node *part) {
    const ir_node *target = expression_written(part);
    if (target && !(target->kind == IR_VARIABLE && target->variable == j->counted.counter) &&
        (target->kind != IR_VARIABLE || !induction_take(j, target->variable)))
        return judgement_refuse(j, REASON_SCALAR_CARRIED, part, judgement_name(j, target));
    for (unsigned i = 0; i < part->child_count; i++)
        if (!take_steps(j, part->children[i]))
            return false;
    return true;
}

bool judge_header_steps(judgement *j) {
    for (unsigned i = 0; i < j->counted.start_count; i++)
        if (!induction_take(j, j->counted.starts[i]->children[0]->variable))
            return judgement_refuse(j, REASON_SCALAR_CARRIED, j->counted.starts[i],
                                    j->counted.starts[i]->children[0]->variable->name);
    return j->loop->kind != IR_FOR || take_steps(j, j->loop->children[2]);
}
