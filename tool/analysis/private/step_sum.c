/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* An amount is a sum of constants and of values that do not change in the loop. Sums are computed
 * modulo 2^64 and then converted to the variable's type, so the order of the additions does not
 * matter. */
#include "analysis/private/step_sum.h"

#include <assert.h>

#include "analysis/base/counted_stride.h"
#include "analysis/base/expression.h"
#include "analysis/loop/executed.h"
#include "analysis/private/triangle.h"

static bool is_in_header(const loop_analysis *j, const ir_node *write) {
    return j->loop->kind == IR_FOR && ir_contains(j->loop->children[2], write);
}

bool step_is_in_each(const loop_analysis *j, const ir_node *write) {
    if (ir_contains(j->counted.body, write))
        return executed_in_each_staying(j, write);
    return is_in_header(j, write) && executed_certainly_in(j->loop->children[2], write);
}

/* Does nothing in the loop write the variable through a pointer? This is proved, without a guard at
 * run time. Distributed stores are not among the loop's accesses. */
static bool stays(const loop_analysis *j, const ir_node *variable) {
    const location from = location_of(j->an->facts, variable, j->loop);
    access_list list = {0};
    access_collect(j->an->effects, j->loop, &list);
    for (unsigned i = 0; i < list.items.count; i++) {
        const access *a = &list.items.items[i];
        if (a->kind == ACCESS_READ)
            continue;
        if (!a->lvalue)
            return false;
        const location to = location_of(j->an->facts, a->lvalue, j->loop);
        if (locations_overlap(&j->an->rules, &from, &to) != OVERLAP_NO)
            return false;
    }
    return !j->left_out.distribution;
}

static bool all_stay(const loop_analysis *j, const ir_node *node) {
    if (node->kind == IR_VARIABLE && node->variable->address_taken && !stays(j, node))
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!all_stay(j, node->children[i]))
            return false;
    return true;
}

/* Has the expression the same value in all iterations? */
static bool is_steady(const loop_analysis *j, const ir_node *node) {
    return stride_is_unwritten(j->loop, node) && all_stay(j, node);
}

/* Adds times * value. Returns false if there are too many different values. */
static bool add_stride(private_variable *item, const ir_node *value, int64_t times) {
    assert(times == 1 || times == -1);
    for (unsigned i = 0; i < item->stride_count; i++)
        if (expression_same(item->strides[i].value, value)) {
            item->strides[i].times += times;
            return true;
        }
    if (item->stride_count == MOST_STRIDES)
        return false;
    item->strides[item->stride_count++] = (variable_stride){value, times};
    return true;
}

/* Adds the step if the write is one of the variable: v++, v += c, v += e. */
static bool add_step(const loop_analysis *j, const ir_node *write, const ir_variable *variable,
                     private_variable *item) {
    ir_variable *stepped;
    int64_t step;
    bool is_down;
    if (counted_step(write, &stepped, &step) && stepped == variable) {
        item->step += step;
        return true;
    }
    const ir_node *stride = item->inner.loop ? NULL : stride_added(write, variable, &is_down);
    return stride && is_steady(j, stride) && add_stride(item, stride, is_down ? -1 : 1);
}

/* ---- steps of the variable itself ------------------------------------------------------------ */

/* Checks a step by an inner loop. Either all steps of a variable are made by iterations of the
 * analysed loop, or all by those of the same inner loop. */
static bool is_step_of_inner(const loop_analysis *j, const ir_node *write, bool is_first,
                             private_variable *item) {
    triangle inner;
    if (!triangle_around(j, write, &inner) || item->variable->type->kind == IR_POINTER ||
        (!is_first && item->inner.loop != inner.loop))
        return false;
    item->inner = inner;
    return true;
}

/* Is the write made by the loop's iterations, not by its header before them? */
static bool is_of_iterations(const loop_analysis *j, const ir_variable *variable,
                             const ir_node *write) {
    const loop_start *start = analysis_start_of(j, variable);
    return ir_contains(j->loop, write) && !(start && write == start->node);
}

/* Adds all writes of the variable, if they are steps. */
static bool add_own_steps(const loop_analysis *j, private_variable *item) {
    const variable_fact *fact = variable_fact_of(j->an->facts, item->variable);
    bool is_first = true;
    for (unsigned i = 0; i < fact->writes.count; i++) {
        const ir_node *write = fact->writes.items[i];
        if (!is_of_iterations(j, item->variable, write))
            continue;
        if (step_is_in_each(j, write) ? item->inner.loop != NULL
                                      : !is_step_of_inner(j, write, is_first, item))
            return false;
        is_first = false;
        if (!add_step(j, write, item->variable, item))
            return false;
    }
    return true;
}

/* ---- through copies -------------------------------------------------------------------------- */

/* Does a conversion from the type `from` to `to` preserve a value as far as `to` can hold it:
 * pointers to objects of the same size, or an integer that is not narrower? */
static bool keeps_value(const ir_type *from, const ir_type *to) {
    if (!from || from->is_volatile || from->is_atomic || from->kind != to->kind)
        return false;
    return to->kind == IR_POINTER ? from->target && from->target->kind != IR_VOID &&
                                        from->target->size == to->target->size
                                  : ir_type_is_plain_integer(from) && from->size >= to->size;
}

/* Does the variable change only by name? */
static bool is_carrier(const loop_analysis *j, const ir_variable *variable) {
    return variable_is_automatic(variable) && variable->function == j->function &&
           !variable->address_taken && !variable->has_other_name;
}

/* Adds a term of a copied sum. */
static bool add_term(const loop_analysis *j, const ir_node *term, bool is_down,
                     private_variable *item) {
    int64_t constant;
    if (expression_constant(term, &constant) && constant <= INT32_MAX && constant >= -INT32_MAX) {
        item->step += is_down ? -constant : constant;
        return true;
    }
    return is_steady(j, term) && add_stride(item, term, is_down ? -1 : 1);
}

/* The variable w if the value is w, w + e, w - e or &w[e], with any number of terms e, which are
 * added. Otherwise NULL. */
static const ir_variable *copied_from(const loop_analysis *j, const ir_node *value,
                                      private_variable *item) {
    const ir_type *type = item->variable->type;
    const ir_node *node = value;
    while (node->kind != IR_VARIABLE && keeps_value(node->type, type)) {
        const bool is_address = node->kind == IR_UNARY && node->op == IR_OP_ADDRESS &&
                                node->children[0]->kind == IR_INDEX;
        const bool is_down = node->kind == IR_BINARY && node->op == IR_OP_SUBTRACT;
        const bool is_sum = node->kind == IR_BINARY && node->op == IR_OP_ADD;
        const ir_node *sum = is_address ? node->children[0] : node;
        if (node->kind == IR_CAST)
            node = node->children[0];
        else if ((is_sum || is_down || is_address) && add_term(j, sum->children[1], is_down, item))
            node = sum->children[0];
        else if (is_sum && add_term(j, sum->children[0], false, item))
            node = sum->children[1];
        else
            return NULL;
    }
    return node->kind == IR_VARIABLE && keeps_value(node->type, type) &&
                   is_carrier(j, node->variable)
               ? node->variable
               : NULL;
}

/* Is it a statement, or a part of one that is separated by commas, so that it is executed after all
 * writes before it in the text? */
static bool is_in_sequence(const ir_node *write) {
    const ir_node *node = write;
    while (node->parent && node->parent->kind == IR_BINARY && node->parent->op == IR_OP_COMMA)
        node = node->parent;
    return write->kind == IR_DECLARATOR ||
           (node->parent && (node->parent->kind == IR_EXPRESSION || node->parent->kind == IR_FOR));
}

/* The variable whose value before the write determines the variable's value after it; the
 * difference is added. NULL if there is none. */
static const ir_variable *variable_before(const loop_analysis *j, const ir_node *write,
                                          const ir_variable *variable, private_variable *item) {
    if (add_step(j, write, variable, item))
        return variable;
    const bool is_copy = write->kind == IR_ASSIGN && write->op == IR_OP_NONE;
    return is_in_sequence(write) && (is_copy || write->kind == IR_DECLARATOR)
               ? copied_from(j, write->children[is_copy ? 1 : 0], item)
               : NULL;
}

/* Does one iteration execute `a` before `b`? The header's step follows the body. */
static bool is_before(const loop_analysis *j, const ir_node *a, const ir_node *b) {
    return is_in_header(j, a) == is_in_header(j, b) ? a->id < b->id : is_in_header(j, b);
}

/* Finds the iteration's last write of the variable before `place`, or at all if that is NULL.
 * Returns false if some write is not executed once in each iteration. */
static bool find_last_write(const loop_analysis *j, const ir_variable *variable,
                            const ir_node *place, const ir_node **found) {
    const variable_fact *fact = variable_fact_of(j->an->facts, variable);
    *found = NULL;
    for (unsigned i = 0; i < fact->writes.count; i++) {
        const ir_node *write = fact->writes.items[i];
        if (!is_of_iterations(j, variable, write))
            continue;
        if (!step_is_in_each(j, write))
            return false;
        if ((!place || is_before(j, write, place)) && (!*found || is_before(j, *found, write)))
            *found = write;
    }
    return true;
}

/* Adds all that lies between the variable's value at the beginning of an iteration and its value
 * at the end. It follows the copies backwards from the last write. */
static bool add_through_copies(const loop_analysis *j, private_variable *item) {
    const ir_variable *variable = item->variable;
    const ir_node *write = NULL;
    while (find_last_write(j, variable, write, &write)) {
        if (!write)
            return variable == item->variable;
        variable = variable_before(j, write, variable, item);
        if (!variable)
            return false;
    }
    return false;
}

bool step_sum(const loop_analysis *j, private_variable *item) {
    private_variable sum = *item;
    if (!add_own_steps(j, &sum)) {
        sum = *item;
        if (!add_through_copies(j, &sum))
            return false;
    }
    assert(sum.stride_count <= MOST_STRIDES);
    *item = sum;
    return sum.step <= INT32_MAX && sum.step >= -(int64_t)INT32_MAX;
}
