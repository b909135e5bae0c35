/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/stepped.h"

#include <assert.h>

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "analysis/base/row_steps.h"

/* The greatest step. With a greater one, the range from the first row to the last would contain too
 * many other rows. */
enum { MOST_STEP = 16 };

static bool is_local(const ir_variable *variable) {
    return variable->storage == IR_LOCAL && !variable->address_taken;
}

/* Can the variable be one that the header steps with the counter? An integer for which this is true
 * does not wrap around before the loop ends, because no object has that many elements. */
static bool can_step_with_counter(const ir_node *body, const ir_variable *variable) {
    const ir_type *type = variable->type;
    const bool is_integer =
        type->kind == IR_INTEGER && (ir_type_never_wraps(type) || type->size == 8);
    const bool is_pointer = type->kind == IR_POINTER && type->target->size > 0;
    return (is_integer || is_pointer) && is_local(variable) &&
           !variable_is_written_in(body, variable);
}

static bool is_stepped(const loop_span *span, const ir_variable *variable) {
    for (unsigned i = 0; i < span->stepped_count; i++)
        if (span->stepped[i] == variable)
            return true;
    return false;
}

/* Adds a variable that the header changes in another way than the counter, as in w += dw. */
static bool find_other(const ir_node *step, loop_span *span) {
    const ir_node *target = expression_written(step);
    if (!target || target->kind != IR_VARIABLE || !is_local(target->variable) ||
        is_stepped(span, target->variable) || span->other_count == MOST_STEPPED ||
        !ir_type_is_scalar(target->type) || target->type->is_volatile ||
        (step->kind == IR_ASSIGN && !expression_is_plain(step->children[1])))
        return false;
    span->others[span->other_count++] = target->variable;
    return true;
}

/* Adds the variables that the header steps like the counter: i++, p++, or i += 3, p += 3. */
static bool find_stepped(const ir_node *step, loop_span *span) {
    ir_variable *variable;
    int64_t by;
    if (step->kind == IR_EXPRESSION)
        return find_stepped(step->children[0], span);
    if (step->kind == IR_BINARY && step->op == IR_OP_COMMA)
        return find_stepped(step->children[0], span) && find_stepped(step->children[1], span);
    if (!counted_step(step, &variable, &by) || by != span->counted.step ||
        span->stepped_count == MOST_STEPPED || is_stepped(span, variable) ||
        (variable != span->counted.counter && !can_step_with_counter(span->counted.body, variable)))
        return find_other(step, span);
    span->stepped[span->stepped_count++] = variable;
    return true;
}

/* Is the counter among the stepped variables, and is no variable both stepped and changed in
 * another way? */
static bool are_disjoint(const loop_span *span) {
    for (unsigned i = 0; i < span->other_count; i++)
        if (is_stepped(span, span->others[i]) || span->others[i] == span->counted.counter)
            return false;
    return is_stepped(span, span->counted.counter);
}

bool span_recognise(ir_node *loop, loop_span *span) {
    assert(ir_is_loop(loop));
    *span = (loop_span){.loop = loop};
    if (loop->kind != IR_FOR)
        return false;
    const counted_result counted = counted_recognise_with_others(loop);
    span->counted = counted.loop;
    return counted.is_counted && !counted.loop.stride && counted.loop.step <= MOST_STEP &&
           (counted.loop.step == 1 || counted.loop.counter->type->kind == IR_INTEGER) &&
           (counted.loop.comparison == IR_OP_LESS || counted.loop.comparison == IR_OP_LESS_EQUAL) &&
           find_stepped(loop->children[2], span) && are_disjoint(span);
}

unsigned span_mentions(const loop_span *span, const ir_node *expression) {
    unsigned count = 0;
    for (unsigned i = 0; i < span->stepped_count; i++)
        count += expression_mentions(expression, span->stepped[i]);
    return count;
}

const ir_variable *span_stepped_in(const loop_span *span, const ir_node *expression) {
    for (unsigned i = 0; i < span->stepped_count; i++)
        if (expression_mentions(expression, span->stepped[i]))
            return span_mentions(span, expression) == 1 ? span->stepped[i] : NULL;
    return NULL;
}

bool span_is_recorded(const loop_span *span, const ir_node *row) {
    for (unsigned i = 0; i < span->other_count; i++)
        if (expression_mentions(row, span->others[i]))
            return false;
    const ir_variable *variable = span_stepped_in(span, row);
    return variable ? row_steps_with(row, variable) : span_mentions(span, row) == 0;
}
