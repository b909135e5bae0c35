/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Handles the loop's variables other than its arrays: private ones, with their last values, and
 * those that are only read. */
#include "analysis/private/privates.h"

#include "analysis/base/expression.h"
#include "analysis/base/loop_exits.h"
#include "analysis/private/live.h"

/* Is the write a statement such as k = e;? Generated code can then record the iteration after its
 * copy of the statement. */
static bool is_statement(const ir_node *write, const ir_variable *variable) {
    const ir_node *target = expression_written(write);
    const ir_node *statement = write->parent;
    return target && target->kind == IR_VARIABLE && target->variable == variable &&
           (write->kind == IR_ASSIGN || write->kind == IR_UNARY) && statement &&
           statement->kind == IR_EXPRESSION && statement->range.begin < statement->range.end &&
           !(statement->parent->kind == IR_FOR && statement->parent->children[3] != statement);
}

/* Is every assignment of the variable in the loop a separate statement? */
static bool is_assigned_by_statements(const loop_analysis *j, const ir_variable *variable) {
    const variable_fact *fact = variable_fact_of(j->an->facts, variable);
    if (!ir_type_is_scalar(variable->type) || variable->type->is_volatile ||
        variable->type->is_atomic)
        return false;
    for (unsigned i = 0; i < fact->writes.count; i++)
        if (ir_contains(j->counted.body, fact->writes.items[i]) &&
            !is_statement(fact->writes.items[i], variable))
            return false;
    return true;
}

/* A variable that only the branch of an exit reads gets a last value if that is possible. Otherwise
 * the loop cannot continue at the exit (plan/continuation.h). */
static bool check_last_value(loop_analysis *j, private_variable *item) {
    const ir_variable *variable = item->variable;
    if (item->is_declared_inside || item->is_declared_in_header || item->is_stepped)
        return true;
    if (variable_escapes(j->an->facts, variable))
        return analysis_refuse(j, REASON_ESCAPES, j->loop, variable->name);
    const bool is_live = variable_is_live_after(j->an->facts, j->an->openmp, j->loop, variable);
    if (!is_live && !loop_exits_mention(j->left_out.exits, variable))
        return true;
    private_result result = must_write_check(j->an->prover, j->counted.body, variable);
    item->is_live_after = result.assigned_at_end;
    item->is_conditional_live_out =
        !result.assigned_at_end && is_assigned_by_statements(j, variable);
    return item->is_live_after || item->is_conditional_live_out || !is_live ||
           analysis_refuse(j, REASON_LAST_VALUE, j->loop, variable->name);
}

static bool is_known(const loop_analysis *j, const ir_variable *variable) {
    for (unsigned i = 0; i < j->captured.count; i++)
        if (j->captured.items[i] == variable)
            return true;
    for (unsigned i = 0; i < j->privates.count; i++)
        if (j->privates.items[i].variable == variable)
            return true;
    for (unsigned i = 0; i < j->scalars.count; i++)
        if (j->scalars.items[i].variable == variable)
            return true;
    return variable == j->counted.counter;
}

/* Does the node name a const variable that may hold the address of a static object? gcc may replace
 * the variable by its initialiser, such as `&deleted`, which would then be the address of a
 * copy. */
static bool is_constant_address(const ir_node *node) {
    const ir_type *type = node->kind == IR_VARIABLE ? node->variable->type : NULL;
    return type && type->is_const && node->variable->storage != IR_PARAMETER &&
           (type->kind == IR_POINTER || (type->kind == IR_INTEGER && type->size == 8));
}

/* May each thread have a copy of a variable that the loop only reads? Only scalars and records are
 * copied, and only if the loop does not use their addresses, as in `if (entry[t] == &deleted)`. */
static bool may_be_copied(const loop_analysis *j, const ir_variable *variable) {
    if (variable_written_in(j->an->facts, j->loop, variable) ||
        (!variable_is_automatic(variable) && ir_any(j->loop, is_constant_address)))
        return false;
    if (variable->type->kind != IR_RECORD)
        return ir_type_is_scalar(variable->type);
    return !variable->address_taken && variable->storage != IR_THREAD_LOCAL;
}

/* Does the loop write a thread-local scalar, or take its address? In another thread, the variable's
 * name denotes another object. */
static bool takes_thread_local_address(const loop_analysis *j, const ir_variable *variable) {
    return variable->storage == IR_THREAD_LOCAL && ir_type_is_scalar(variable->type) &&
           variable_written_in(j->an->facts, j->loop, variable);
}

static bool capture(ir_node *node, void *context) {
    loop_analysis *j = context;
    ir_variable *variable = node->variable;
    if (node->kind != IR_VARIABLE || !variable || is_known(j, variable))
        return true;
    if (takes_thread_local_address(j, variable))
        return analysis_refuse(j, REASON_THREAD_LOCAL, node, variable->name);
    if (!may_be_copied(j, variable))
        return true;
    const ir_node *declarator = variable_fact_of(j->an->facts, variable)->declarator;
    if (!declarator || !ir_contains(j->loop, declarator))
        VECTOR_PUSH(j->an->memory, &j->captured, variable);
    return true;
}

static bool is_counter_live_after(const loop_analysis *j) {
    return !j->counted.counter_is_declared_in_header &&
           (j->counted.counter->address_taken ||
            variable_is_live_after(j->an->facts, j->an->openmp, j->loop, j->counted.counter));
}

private_check check_privates(const loop_analysis *j) {
    loop_analysis own = analysis_copy(j);
    for (unsigned i = 0; i < own.privates.count; i++)
        if (!check_last_value(&own, &own.privates.items[i]))
            return (private_check){.why = own.why};
    ir_walk((ir_node *)own.counted.body, capture, &own);
    ir_walk((ir_node *)own.counted.bound, capture, &own);
    return (private_check){own.why, own.privates, own.captured, is_counter_live_after(j)};
}
