/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/stepped.h"

#include <assert.h>

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "analysis/base/row_steps.h"

/* Its values do not wrap around before the loop ends: no object has that many elements. */
static bool may_go_along(const ir_node *body, const ir_variable *variable) {
    const ir_type *type = variable->type;
    return type->kind == IR_INTEGER && ((type->is_signed && type->size >= 4) || type->size == 8) &&
           variable->storage == IR_LOCAL && !variable->address_taken &&
           !variable_is_written_in(body, variable);
}

/* i++, p++ */
static bool find_stepped(const ir_node *step, loop_span *span) {
    ir_variable *variable;
    int64_t by;
    if (step->kind == IR_EXPRESSION)
        return find_stepped(step->children[0], span);
    if (step->kind == IR_BINARY && step->op == IR_OP_COMMA)
        return find_stepped(step->children[0], span) && find_stepped(step->children[1], span);
    if (!counted_step(step, &variable, &by) || by != 1 || span->stepped_count == MOST_STEPPED ||
        (variable != span->counted.counter && !may_go_along(span->counted.body, variable)))
        return false;
    for (unsigned i = 0; i < span->stepped_count; i++)
        if (span->stepped[i] == variable)
            return false;
    span->stepped[span->stepped_count++] = variable;
    return true;
}

bool span_recognise(ir_node *loop, loop_span *span) {
    assert(ir_is_loop(loop));
    *span = (loop_span){.loop = loop};
    if (loop->kind != IR_FOR)
        return false;
    const counted_result counted = counted_recognise_beside(loop);
    span->counted = counted.loop;
    return counted.is_counted &&
           (counted.loop.comparison == IR_OP_LESS || counted.loop.comparison == IR_OP_LESS_EQUAL) &&
           find_stepped(loop->children[2], span);
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

bool span_is_told(const loop_span *span, const ir_node *row) {
    const ir_variable *variable = span_stepped_in(span, row);
    return variable ? row_steps_with(row, variable) : span_mentions(span, row) == 0;
}
