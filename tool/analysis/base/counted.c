/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/counted.h"

#include <assert.h>

#include "analysis/base/counted_bound.h"
#include "analysis/base/counted_condition.h"
#include "analysis/base/counted_start.h"
#include "analysis/base/counted_stride.h"
#include "analysis/base/counted_wraps.h"
#include "analysis/base/expression.h"
#include "analysis/base/step_inside.h"

/* ---- writes of a variable ------------------------------------------------------------------- */

bool variable_is_written_in(const ir_node *node, const ir_variable *variable) {
    const ir_node *target = expression_written(node);
    if (target && target->kind == IR_VARIABLE && target->variable == variable)
        return true;
    if (node->kind == IR_UNARY && node->op == IR_OP_ADDRESS &&
        expression_object(node->children[0]) == variable)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (variable_is_written_in(node->children[i], variable))
            return true;
    return false;
}

/* ---- the parts of a header ------------------------------------------------------------------ */

bool counted_step(const ir_node *node, ir_variable **variable, int64_t *step) {
    const ir_node *target = expression_written(node);
    if (!target || target->kind != IR_VARIABLE)
        return false;
    *variable = target->variable;
    if (node->kind == IR_UNARY) {
        bool is_up = node->op == IR_OP_PRE_INCREMENT || node->op == IR_OP_POST_INCREMENT;
        *step = is_up ? 1 : -1;
        return true;
    }
    const ir_node *value = node->children[1];
    ir_operator op = node->op;
    if (op == IR_OP_NONE) {
        if (value->kind != IR_BINARY)
            return false;
        op = value->op;
        if (expression_is_variable(value->children[0], *variable))
            value = value->children[1];
        else if (op == IR_OP_ADD && expression_is_variable(value->children[1], *variable))
            value = value->children[0];
        else
            return false;
    }
    if ((op != IR_OP_ADD && op != IR_OP_SUBTRACT) || !expression_constant(value, step))
        return false;
    if (*step > INT32_MAX || *step < -INT32_MAX)
        return false;
    if (op == IR_OP_SUBTRACT)
        *step = -*step;
    return true;
}

static bool is_comparison(ir_operator op) {
    return (op >= IR_OP_LESS && op <= IR_OP_GREATER_EQUAL) || op == IR_OP_NOT_EQUAL;
}

/* Is it the counter, or counter + c in the counter's type with a constant c >= 0? Stores c, or 0,
 * in *ahead. */
static bool is_compared(const ir_node *node, const ir_variable *counter, int64_t *ahead) {
    *ahead = 0;
    if (expression_is_variable(node, counter))
        return true;
    if (node->kind != IR_BINARY || node->op != IR_OP_ADD || !ir_type_is_plain_integer(node->type) ||
        !ir_type_equal(node->type, counter->type))
        return false;
    const unsigned side = expression_is_variable(node->children[0], counter) ? 0 : 1;
    return expression_is_variable(node->children[side], counter) &&
           expression_constant(node->children[1 - side], ahead) && *ahead >= 0 &&
           *ahead <= INT16_MAX;
}

/* Is it `v != 0` with an unsigned counter v that counts down? Then it means the same as `v > 0`. */
static bool is_above_zero(const counted_loop *counted) {
    int64_t bound;
    return counted->comparison == IR_OP_NOT_EQUAL && counted->ahead == 0 && counted->step < 0 &&
           ir_type_is_plain_integer(counted->counter->type) && !counted->counter->type->is_signed &&
           expression_constant(counted->bound, &bound) && bound == 0;
}

/* Splits a condition that compares the counter, on either side, with a bound. Returns false if the
 * condition has another form, or if the bound mentions the counter. The step is known. */
static bool split_condition(const ir_node *condition, counted_loop *counted) {
    if (expression_is_variable(condition, counted->counter)) {
        counted_split_bare(counted);
        counted->comparison = is_above_zero(counted) ? IR_OP_GREATER : IR_OP_NOT_EQUAL;
        return true;
    }
    if (condition->kind != IR_BINARY || !is_comparison(condition->op))
        return false;
    if (is_compared(condition->children[0], counted->counter, &counted->ahead)) {
        counted->comparison = condition->op;
        counted->bound = condition->children[1];
    } else if (is_compared(condition->children[1], counted->counter, &counted->ahead)) {
        counted->comparison = expression_mirrored(condition->op);
        counted->bound = condition->children[0];
    } else {
        return false;
    }
    assert(is_comparison(counted->comparison));
    if (is_above_zero(counted))
        counted->comparison = IR_OP_GREATER;
    return !expression_mentions(counted->bound, counted->counter);
}

/* ---- the whole header ------------------------------------------------------------------------ */

static counted_result not_counted(reason_id why, const ir_node *node, const char *name) {
    assert(name || why == REASON_TRIP_COUNT);
    return (counted_result){.why = why, .node = node, .name = name};
}

static bool written_by(const ir_node *body, const ir_node *bound, const char **name) {
    if (bound->kind == IR_VARIABLE && variable_is_written_in(body, bound->variable)) {
        *name = bound->variable->name;
        return true;
    }
    for (unsigned i = 0; i < bound->child_count; i++)
        if (written_by(body, bound->children[i], name))
            return true;
    return false;
}

static bool step_agrees(const counted_loop *loop) {
    switch (loop->comparison) {
    case IR_OP_LESS:
    case IR_OP_LESS_EQUAL:
        return loop->step > 0;
    case IR_OP_GREATER:
    case IR_OP_GREATER_EQUAL:
        return loop->step < 0;
    default:
        return !loop->stride && (loop->step == 1 || loop->step == -1);
    }
}

static bool is_address(const ir_node *node) {
    return node->type && (node->type->kind == IR_POINTER || node->type->kind == IR_ARRAY);
}

/* Does the pointer step over objects of known size? As a loop's counter, such a pointer has
 * addresses as values, and its step is in bytes. */
static bool is_plain_pointer(const ir_type *type) {
    const ir_type *object = type->kind == IR_POINTER ? type->target : NULL;
    return object && object->size > 0 && object->size <= INT16_MAX && object->kind != IR_VOID &&
           object->kind != IR_ARRAY && object->kind != IR_FUNCTION_TYPE && !type->is_volatile &&
           !type->is_atomic;
}

static bool is_plain_end(const counted_loop *loop, const ir_node *node) {
    return loop->counter->type->kind == IR_POINTER ? is_address(node)
                                                   : ir_type_is_plain_integer(node->type);
}

/* Does the expression contain no assignment, increment or opaque node? Calls are permitted. */
static bool is_plain_but_for_calls(const ir_node *node) {
    if (node->kind == IR_OPAQUE || expression_written(node))
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!is_plain_but_for_calls(node->children[i]))
            return false;
    return true;
}

static bool compares_while_stepping(const counted_loop *loop) {
    return loop->steps_first || loop->ends_below;
}

static bool may_count(const counted_loop *loop) {
    return variable_is_automatic(loop->counter) &&
           (ir_type_is_plain_integer(loop->counter->type) ||
            (is_plain_pointer(loop->counter->type) && !compares_while_stepping(loop)));
}

static bool wraps(const counted_loop *counted, const ir_node *loop) {
    const ir_type *counter = counted->counter->type;
    if (counter->kind == IR_POINTER) /* the behaviour of a pointer that leaves its object is
                                      * undefined in C */
        return false;
    if (compares_while_stepping(counted))
        return counted_stepping_wraps(counted);
    /* If the first value is beyond the bound, the computed trip count is not positive, and the
     * original loop runs. */
    if (loop->kind == IR_DO && counted->comparison == IR_OP_NOT_EQUAL && !counter->is_signed)
        return counter->size < 4 || counted->bound->type->size > counter->size;
    return counted_wraps(counted) && !counted_wrap_is_seen(counted);
}

/* May the condition be `i + c < n` with `c > 0`? Such a loop counts like one with `i < n - c`: when
 * it ends, `i + c` equals the bound, or one more (<=), just as `i` does for `i < n`. Steps greater
 * than 1 are excluded, because `i + c` might exceed the type's greatest value. */
static bool may_compare_ahead(const counted_loop *loop, const ir_node *node) {
    return loop->ahead == 0 ||
           (!loop->counter->type->wraps && loop->step == 1 && !loop->stride &&
            node->kind != IR_DO && !loop->steps_inside &&
            (loop->comparison == IR_OP_LESS || loop->comparison == IR_OP_LESS_EQUAL));
}

/* Checks the loop's counter, bound and first value, once they are found. */
static counted_result check(counted_loop *loop, const ir_node *node, const ir_node *increment) {
    assert(loop->step != 0);
    const char *name = loop->counter->name;
    const char *written = NULL;
    if (!may_count(loop))
        return not_counted(REASON_COUNTER_TYPE, node, name);
    if (!is_plain_end(loop, loop->bound) || !may_compare_ahead(loop, node))
        return not_counted(REASON_TRIP_COUNT, loop->bound, name);
    if (!is_plain_but_for_calls(loop->bound) ||
        (node->kind == IR_DO && !counted_bound_is_safe_before(loop->bound)))
        return not_counted(REASON_TRIP_COUNT, loop->bound, name);
    if (loop->lower && (!expression_is_plain(loop->lower) || !is_plain_end(loop, loop->lower)))
        return not_counted(REASON_TRIP_COUNT, loop->lower, name);
    for (unsigned i = 0; !loop->steps_inside && (i < loop->body->child_count || i == 0); i++) {
        /* skips an increment that is a statement of the body */
        const ir_node *part = loop->body->kind == IR_BLOCK ? ir_child(loop->body, i) : loop->body;
        if (!part || part == increment)
            continue;
        if (variable_is_written_in(part, loop->counter))
            return not_counted(REASON_COUNTER_MODIFIED, part, name);
        if (part == loop->body)
            break;
    }
    if (written_by(loop->body, loop->bound, &written))
        return not_counted(REASON_BOUND_VARIES, loop->bound, written);
    if (!step_agrees(loop))
        return not_counted(REASON_STEP, node, name);
    if (wraps(loop, node))
        return not_counted(REASON_COUNTER_WRAPS, node, name);
    if (loop->counter->type->kind == IR_POINTER)
        loop->step *= loop->counter->type->target->size;
    return (counted_result){.is_counted = true, .loop = *loop};
}

/* Fills in counter, step and stride from an increment such as v++, v += c or v += e. */
static bool split_step(const ir_node *loop, const ir_node *increment, counted_loop *counted) {
    return counted_step(increment, &counted->counter, &counted->step) ||
           counted_split_stride(loop, increment, counted);
}

/* Returns the part of an increment such as `i++, q += 3` that steps the variable which the
 * condition compares. NULL if there is none. */
static const ir_node *own_increment(const ir_node *loop, const ir_node *increment,
                                    const ir_node *condition) {
    counted_loop counted = {0};
    if (increment->kind != IR_BINARY || increment->op != IR_OP_COMMA)
        return split_step(loop, increment, &counted) && split_condition(condition, &counted)
                   ? increment
                   : NULL;
    const ir_node *left = own_increment(loop, increment->children[0], condition);
    return left ? left : own_increment(loop, increment->children[1], condition);
}

/* Does the increment, as in `i++, i++`, write the counter other than by the node `step`? */
static bool is_written_elsewhere(const ir_node *node, const ir_variable *counter,
                                 const ir_node *step) {
    if (node == step)
        return false;
    if (node->kind != IR_BINARY || node->op != IR_OP_COMMA)
        return variable_is_written_in(node, counter);
    return is_written_elsewhere(node->children[0], counter, step) ||
           is_written_elsewhere(node->children[1], counter, step);
}

static const ir_node *expression_of(const ir_node *part) {
    return part->kind == IR_EXPRESSION ? part->children[0] : part;
}

static bool split_start(const ir_node *loop, counted_loop *counted) {
    const ir_node *start = loop->children[0];
    return start->kind == IR_DECLARATION ? counted_split_declaration(loop, start, counted)
                                         : counted_split_initialisation(loop, start, counted);
}

static const ir_node *call_in(const ir_node *node) {
    const ir_node *call = node->kind == IR_CALL ? node : NULL;
    for (unsigned i = 0; i < node->child_count && !call; i++)
        call = call_in(node->children[i]);
    return call;
}

/* Does the header's third part do something besides steps, which generated code would not repeat?
 * If so, stores the reason. */
static bool has_other_work(const ir_node *part, counted_result *result) {
    const ir_node *call = call_in(part);
    if (call)
        *result =
            not_counted(REASON_IMPURE_CALL, call,
                        call->children[0]->kind == IR_FUNCTION ? call->children[0]->function->name
                                                               : "a function");
    else if (ir_has_kind(part, IR_OPAQUE))
        *result = not_counted(REASON_TRIP_COUNT, part, NULL);
    else
        return false;
    return true;
}

/* Recognises a loop whose condition steps the counter: for (i = n; --i >= 0;), while (n--), do ...
 * while (--n). Nothing else in the header may step it. */
static counted_result recognise_stepping(const ir_node *loop, counted_loop *counted) {
    const char *name = counted->counter->name;
    const char *written = NULL;
    if (loop->kind == IR_FOR) {
        counted_result refused;
        if (has_other_work(loop->children[2], &refused))
            return refused;
        if (!split_start(loop, counted))
            return not_counted(REASON_TRIP_COUNT, loop->children[0], name);
        if (variable_is_written_in(loop->children[2], counted->counter))
            return not_counted(REASON_COUNTER_MODIFIED, loop->children[2], name);
        if (written_by(loop->children[2], counted->bound, &written))
            return not_counted(REASON_BOUND_VARIES, counted->bound, written);
    }
    return check(counted, loop, NULL);
}

/* Recognises a step inside the body, as in while (p < end) h[*p++]++ and for (; p < end;)
 * h[*p++]++. Each iteration must execute the step exactly once and not use the counter after it. */
static bool split_inside(const ir_node *condition, counted_loop *counted) {
    for (unsigned side = 0; condition->kind == IR_BINARY && side < 2; side++) {
        const ir_node *compared = condition->children[side];
        const ir_node *step = compared->kind == IR_VARIABLE
                                  ? lone_last_step(counted->body, compared->variable)
                                  : NULL;
        if (!step || may_continue_before(counted->body, step) ||
            !counted_step(step, &counted->counter, &counted->step) ||
            !split_condition(condition, counted))
            continue;
        counted->increment = step;
        counted->steps_inside = true;
        return true;
    }
    return false;
}

/* Is the statement a step of the variable that the condition compares? */
static bool split_step_statement(const ir_node *loop, const ir_node *condition,
                                 const ir_node *statement, counted_loop *counted) {
    *counted = (counted_loop){.body = counted->body, .increment = statement};
    return statement->kind == IR_EXPRESSION && split_step(loop, statement->children[0], counted) &&
           split_condition(condition, counted);
}

/* Does the declaration declare only scalars and pointers to them, so that it has no other
 * expressions than initialisers? */
static bool declares_scalars(const ir_node *statement) {
    for (unsigned i = 0; i < statement->child_count; i++) {
        const ir_node *declarator = statement->children[i];
        const ir_type *type = declarator->kind == IR_DECLARATOR ? declarator->variable->type : NULL;
        while (type && type->kind == IR_POINTER)
            type = type->target;
        if (!type || !ir_type_is_scalar(type))
            return false;
    }
    return statement->kind == IR_DECLARATION;
}

/* Recognises a step that precedes all other statements of the body, but for declarations that do
 * not mention the counter, as in while (k > 0) { --k; h[s[k]]++; }. The body may `continue` after
 * it. */
static bool split_step_at_start(const ir_node *loop, const ir_node *condition,
                                counted_loop *counted) {
    const ir_node *body = counted->body;
    unsigned at = 0;
    while (at < body->child_count && declares_scalars(body->children[at]))
        at++;
    if (at == body->child_count ||
        !split_step_statement(loop, condition, body->children[at], counted) || counted->step == 0)
        return false;
    for (unsigned i = 0; i < at; i++)
        if (expression_mentions(body->children[i], counted->counter))
            return false;
    counted->steps_at_start = true;
    return true;
}

/* Recognises a step that is the last or the first statement of the body. */
static counted_result recognise_step_statement(const ir_node *loop, const ir_node *condition,
                                               counted_loop *counted) {
    const ir_node *body = counted->body;
    if (body->kind != IR_BLOCK || body->child_count == 0)
        return not_counted(REASON_TRIP_COUNT, loop, NULL);
    const ir_node *last = body->children[body->child_count - 1];
    if (split_step_statement(loop, condition, last, counted)) {
        if (ir_continues(body) || counted->step == 0)
            return not_counted(REASON_TRIP_COUNT, loop, counted->counter->name);
    } else if (!split_step_at_start(loop, condition, counted)) {
        return not_counted(REASON_TRIP_COUNT, condition, NULL);
    }
    if (loop->kind == IR_FOR && !split_start(loop, counted))
        return not_counted(REASON_TRIP_COUNT, condition, counted->counter->name);
    return check(counted, loop, counted->increment);
}

static counted_result recognise_for(const ir_node *loop) {
    const ir_node *increment = expression_of(loop->children[2]);
    const ir_node *condition = expression_of(loop->children[1]);
    counted_loop counted = {.body = loop->children[3]};
    if (counted_split_stepping(condition, &counted))
        return recognise_stepping(loop, &counted);
    counted = (counted_loop){.body = loop->children[3]};
    if (increment->kind == IR_EMPTY && split_inside(condition, &counted) &&
        split_start(loop, &counted))
        return check(&counted, loop, NULL);
    counted = (counted_loop){.body = loop->children[3]};
    if (condition->kind == IR_EMPTY)
        return not_counted(REASON_TRIP_COUNT, loop, NULL);
    if (increment->kind == IR_EMPTY)
        return recognise_step_statement(loop, condition, &counted);
    const ir_node *all = increment;
    if (increment->kind == IR_BINARY && increment->op == IR_OP_COMMA) {
        counted_result refused;
        if (has_other_work(all, &refused))
            return refused;
        increment = own_increment(loop, increment, condition);
    }
    if (!increment)
        return not_counted(REASON_TRIP_COUNT, all, NULL);
    counted.increment = increment;
    if (!split_step(loop, increment, &counted)) {
        ir_variable *variable = ir_root_variable(
            expression_written(increment) ? expression_written(increment) : increment);
        return not_counted(variable ? REASON_STEP : REASON_TRIP_COUNT, increment,
                           variable ? variable->name : NULL);
    }
    if (counted.step == 0)
        return not_counted(REASON_STEP, increment, counted.counter->name);
    if (!split_condition(condition, &counted) || !split_start(loop, &counted))
        return not_counted(REASON_TRIP_COUNT, condition, counted.counter->name);
    const char *written = NULL;
    if (all != increment && written_by(all, counted.bound, &written))
        return not_counted(REASON_BOUND_VARIES, counted.bound, written);
    if (is_written_elsewhere(all, counted.counter, increment))
        return not_counted(REASON_COUNTER_MODIFIED, all, counted.counter->name);
    return check(&counted, loop, NULL);
}

/* Recognises a while or do loop. A do loop is counted like the while loop with the same body and
 * condition. If that while loop would have no iteration, the computed trip count is not positive
 * and the original loop runs. */
static counted_result recognise_while(const ir_node *loop) {
    const bool is_do = loop->kind == IR_DO;
    const ir_node *condition = loop->children[is_do ? 1 : 0];
    const ir_node *body = loop->children[is_do ? 0 : 1];
    counted_loop counted = {.body = body};
    if (counted_split_stepping(condition, &counted)) {
        counted.steps_first &= !is_do;
        return recognise_stepping(loop, &counted);
    }
    counted = (counted_loop){.body = body};
    if (split_inside(condition, &counted))
        return check(&counted, loop, NULL);
    counted = (counted_loop){.body = body};
    return recognise_step_statement(loop, condition, &counted);
}

bool counted_steps_by_statement(const ir_node *loop, const counted_loop *counted) {
    return counted->steps_at_start || (loop->kind == IR_FOR && !counted->steps_inside &&
                                       ir_contains(counted->body, counted->increment));
}

counted_result counted_recognise_analysed(ir_node *loop) {
    assert(ir_is_loop(loop));
    if (loop->kind == IR_FOR)
        return recognise_for(loop);
    return recognise_while(loop);
}

/* Rejects loops that only counted_recognise_analysed accepts. */
static counted_result restricted(counted_result result, const ir_node *loop, bool steps_others) {
    if (!result.is_counted)
        return result;
    if (loop->kind == IR_DO || compares_while_stepping(&result.loop) ||
        counted_steps_by_statement(loop, &result.loop) || counted_is_bare(&result.loop))
        return not_counted(REASON_TRIP_COUNT, result.loop.increment, result.loop.counter->name);
    if (result.loop.counter->address_taken)
        return not_counted(REASON_COUNTER_MODIFIED, loop, result.loop.counter->name);
    const ir_node *header = loop->kind == IR_FOR ? loop->children[2] : NULL;
    if (header && header->kind == IR_EXPRESSION)
        header = header->children[0];
    if (header && !steps_others && (header != result.loop.increment || result.loop.start_count))
        return not_counted(REASON_TRIP_COUNT, header, result.loop.counter->name);
    if (!expression_is_plain(result.loop.bound) || result.loop.bound_variable)
        return not_counted(REASON_TRIP_COUNT, result.loop.bound, result.loop.counter->name);
    if (result.loop.counter->type->kind == IR_POINTER)
        return not_counted(REASON_COUNTER_TYPE, loop, result.loop.counter->name);
    if (result.loop.steps_inside)
        return not_counted(REASON_COUNTER_MODIFIED, loop, result.loop.counter->name);
    if (result.loop.ahead)
        return not_counted(REASON_TRIP_COUNT, result.loop.bound, result.loop.counter->name);
    if (result.loop.stride)
        return not_counted(REASON_STEP, result.loop.stride, result.loop.counter->name);
    if (counted_wraps(&result.loop))
        return not_counted(REASON_COUNTER_WRAPS, loop, result.loop.counter->name);
    return result;
}

counted_result counted_recognise(ir_node *loop) {
    return restricted(counted_recognise_analysed(loop), loop, false);
}

counted_result counted_recognise_with_others(ir_node *loop) {
    return restricted(counted_recognise_analysed(loop), loop, true);
}

/* ---- constant loops and ranges -------------------------------------------------------------- */

bool counted_constant(const ir_node *loop, const ir_variable **counter, int64_t *first,
                      int64_t *last) {
    if (loop->kind != IR_FOR)
        return false;
    counted_result r = restricted(recognise_for(loop), loop, false);
    int64_t lower, bound;
    if (!r.is_counted || !r.loop.lower || !expression_constant(r.loop.lower, &lower) ||
        !expression_constant(r.loop.bound, &bound))
        return false;
    if (lower > INT32_MAX || lower < INT32_MIN || bound > INT32_MAX || bound < INT32_MIN)
        return false;
    bool is_up = r.loop.step > 0;
    if (r.loop.comparison == IR_OP_LESS || (r.loop.comparison == IR_OP_NOT_EQUAL && is_up))
        bound--;
    if (r.loop.comparison == IR_OP_GREATER || (r.loop.comparison == IR_OP_NOT_EQUAL && !is_up))
        bound++;
    if (is_up ? lower > bound : lower < bound)
        return false;
    bound = lower + (bound - lower) / r.loop.step * r.loop.step; /* the last value in the body */
    *counter = r.loop.counter;
    *first = is_up ? lower : bound;
    *last = is_up ? bound : lower;
    assert(*first <= *last);
    return true;
}

bool counted_constant_sets(const ir_node *node, const ir_variable *variable) {
    const ir_variable *counter;
    int64_t first, last;
    if (counted_constant(node, &counter, &first, &last) && counter == variable)
        return true;
    if (node->kind == IR_OPAQUE || node->kind == IR_GOTO || expression_is_variable(node, variable))
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!counted_constant_sets(node->children[i], variable))
            return false;
    return true;
}

constant_loop counted_constant_around(const ir_node *node, const ir_node *outermost,
                                      const ir_variable *variable) {
    const ir_node *child = node;
    for (const ir_node *loop = node->parent; loop && loop != outermost;
         child = loop, loop = loop->parent) {
        const ir_variable *counter;
        constant_loop found = {.loop = loop};
        if (loop->kind == IR_FOR && child == loop->children[3] &&
            counted_constant(loop, &counter, &found.first, &found.last) && counter == variable)
            return found;
    }
    return (constant_loop){0};
}

static bool counter_range(const ir_node *node, int64_t *low, int64_t *high) {
    const constant_loop found = counted_constant_around(node, NULL, node->variable);
    *low = found.first;
    *high = found.last;
    return found.loop != NULL;
}

static bool binary_range(const ir_node *node, int64_t *low, int64_t *high) {
    int64_t a, b, c, d;
    if (!counted_range(node->children[0], &a, &b) || !counted_range(node->children[1], &c, &d))
        return false;
    assert(a <= b && c <= d);
    switch (node->op) {
    case IR_OP_ADD:
        *low = a + c;
        *high = b + d;
        break;
    case IR_OP_SUBTRACT:
        *low = a - d;
        *high = b - c;
        break;
    case IR_OP_MULTIPLY:
        if (a < 0 || c < 0)
            return false;
        *low = a * c;
        *high = b * d;
        break;
    default:
        return false;
    }
    return *low >= INT32_MIN && *high <= INT32_MAX && (node->type->is_signed || *low >= 0);
}

bool counted_range(const ir_node *expression, int64_t *low, int64_t *high) {
    int64_t value;
    if (expression_constant(expression, &value)) {
        *low = *high = value;
        return value >= INT32_MIN && value <= INT32_MAX;
    }
    if (expression->kind == IR_VARIABLE)
        return counter_range(expression, low, high);
    if (expression->kind == IR_BINARY && expression->type && expression->type->kind == IR_INTEGER &&
        expression->type->size >= 4)
        return binary_range(expression, low, high);
    return false;
}
