/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* If every iteration adds the same c to v unconditionally, then in iteration number n, counted from
 * 0,
 *     v = v0 + c * n,
 * where v0 is the value of v before the loop. Each iteration can begin with a copy that has this
 * value, and execute its text unchanged. The value is computed modulo 2^64 and converted to v's
 * type, so it equals the value in the sequential loop unless v overflows there. If instead each
 * iteration of an inner loop adds c, n is the number of inner iterations before the current outer
 * one (triangle.h). */
#include "analysis/private/induction.h"

#include <assert.h>

#include "analysis/base/expression.h"
#include "analysis/base/step_inside.h"
#include "analysis/private/live.h"
#include "analysis/private/step_sum.h"

/* Is the type a pointer to objects of a known size greater than 0? */
static bool is_pointer(const ir_type *type) {
    return type->kind == IR_POINTER && !type->is_volatile && !type->is_atomic && type->target &&
           type->target->kind != IR_VOID && type->target->size > 0;
}

static bool is_of_function(const loop_analysis *j, const ir_variable *variable) {
    const ir_node *declarator = variable_fact_of(j->an->facts, variable)->declarator;
    return (variable->storage == IR_LOCAL || variable->storage == IR_PARAMETER) &&
           variable->function == j->function && !variable->address_taken &&
           !variable->has_other_name &&
           (analysis_header_declares(j, variable) ||
            !(declarator && ir_contains(j->loop, declarator)));
}

static bool is_taken(const loop_analysis *j, const ir_variable *variable) {
    for (unsigned i = 0; i < j->privates.count; i++)
        if (j->privates.items[i].variable == variable)
            return true;
    return false;
}

bool induction_take(loop_analysis *j, const ir_variable *variable) {
    const loop_start *start = analysis_start_of(j, variable);
    assert(variable != j->counted.counter);
    private_variable item = {.variable = (ir_variable *)variable,
                             .entry = start ? start->value : NULL,
                             .is_declared_in_header = start && start->is_declared,
                             .is_stepped = true};
    if (is_taken(j, variable))
        return true;
    if ((!ir_type_is_plain_integer(variable->type) && !is_pointer(variable->type)) ||
        !is_of_function(j, variable) || !step_sum(j, &item))
        return false;
    /* if the header does not set the variable, a later execution of the loop continues with its
     * last value */
    item.is_step_wanted =
        !start || (!start->is_declared &&
                   variable_is_live_after(j->an->facts, j->an->openmp, j->loop, variable));
    VECTOR_PUSH(j->an->memory, &j->privates, item);
    return true;
}

/* Does the next iteration ignore the value that the variable has at the end of this one? It does if
 * the variable is stepped, because a stepped variable begins each iteration with a computed
 * value. */
static bool is_unused_at_end(const loop_analysis *j, const ir_variable *variable) {
    const ir_node *declarator = variable_fact_of(j->an->facts, variable)->declarator;
    private_variable item = {.variable = (ir_variable *)variable};
    return variable == j->counted.counter || (declarator && ir_contains(j->loop, declarator)) ||
           step_sum(j, &item);
}

bool induction_is_last_step(const loop_analysis *j, const ir_node *statement, const ir_node *step) {
    if (!is_step_afterwards(step) || !step_is_in_each(j, step))
        return false;
    const ir_variable *variable = step->children[0]->variable;
    const variable_fact *fact = variable_fact_of(j->an->facts, variable);
    for (unsigned i = 0; i < fact->occurrences.count; i++) {
        const ir_node *use = fact->occurrences.items[i];
        if (use != step->children[0] && ir_contains(j->counted.body, use) &&
            use->id >= statement->id)
            return false;
    }
    return variable_is_automatic(variable) && variable->function == j->function &&
           !variable->address_taken && !variable->has_other_name && is_unused_at_end(j, variable);
}

static bool take_steps(loop_analysis *j, const ir_node *part) {
    const ir_node *target = expression_written(part);
    if (target && !(target->kind == IR_VARIABLE && target->variable == j->counted.counter) &&
        (target->kind != IR_VARIABLE || !induction_take(j, target->variable)))
        return analysis_refuse(j, REASON_SCALAR_CARRIED, part, analysis_name(j, target));
    for (unsigned i = 0; i < part->child_count; i++)
        if (!take_steps(j, part->children[i]))
            return false;
    return true;
}

/* May the variable be set before the loop, although the original loop, which runs if a guard fails,
 * sets it again? Whether the variable is private is decided where the loop writes it. */
static bool is_start_of_own(const loop_analysis *j, const loop_start *start) {
    const ir_variable *v = start->variable;
    return variable_is_automatic(v) && v->function == j->function && !v->address_taken &&
           !v->has_other_name && !v->type->is_volatile && !v->type->is_atomic &&
           (!start->is_declared || v->type->spelling) && variable_is_written_in(j->counted.body, v);
}

static bool take_starts(loop_analysis *own) {
    for (unsigned i = 0; i < own->counted.start_count; i++) {
        const loop_start *start = &own->counted.starts[i];
        if (!induction_take(own, start->variable) && !is_start_of_own(own, start))
            return analysis_refuse(own, REASON_SCALAR_CARRIED, start->node, start->variable->name);
    }
    return true;
}

step_result check_header_steps(const loop_analysis *j) {
    loop_analysis own = analysis_copy(j);
    if (take_starts(&own) && own.loop->kind == IR_FOR)
        take_steps(&own, own.loop->children[2]);
    return (step_result){own.why, own.privates};
}
