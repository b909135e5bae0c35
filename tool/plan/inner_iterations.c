/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/inner_iterations.h"

#include <assert.h>

#include "analysis/base/expression.h"
#include "analysis/base/stepped.h"
#include "ir/ir_syntax.h"
#include "plan/inner_variables.h"
#include "plan/lookup.h"
#include "plan/only_read.h"
#include "plan/unconditional.h"

enum {
    LEAST_WORK = 4, /* number of floating-point operations and calls for which another ownership
                     * check pays */
    MOST_SUMS = 12
};

typedef struct inner_rest {
    const loop_facts *facts;
    const ir_node *inner; /* the inner loop */
    const ir_node *block; /* the inner loop's body */
    unsigned rest;        /* index in `block` of the first statement that may be skipped. "The rest"
                           * is this statement and all statements after it */
    unsigned row_count;
    skip_row rows[MOST_SKIP_ROWS];
    bool adds_to_series; /* the rest adds to a series */
    unsigned sum_count;
    const ir_variable *sums[MOST_SUMS]; /* variables that the rest adds to */
} inner_rest;

/* ---- effects of the rest of an iteration ----------------------------------------------------- */

static bool is_own_variable(const inner_rest *t, const ir_variable *variable) {
    for (unsigned i = t->rest; variable && i < t->block->child_count; i++)
        if (ir_declarator_in(t->block->children[i], variable))
            return true;
    return false;
}

static const private_variable *private_of(const loop_facts *facts, const ir_variable *variable) {
    for (unsigned i = 0; i < facts->variables.private_count; i++)
        if (facts->variables.privates[i].variable == variable)
            return &facts->variables.privates[i];
    return NULL;
}

/** Is the variable private to an iteration of the outer loop, and not live-out? */
static bool is_of_iteration(const inner_rest *t, const ir_variable *variable) {
    const private_variable *it = private_of(t->facts, variable);
    return it && !it->is_live_after && !it->is_conditional_live_out && !it->is_stepped &&
           !variable->address_taken;
}

/** Is the variable private, and is its value dead at the end of an inner iteration? */
static bool is_dead(const inner_rest *t, const ir_variable *variable) {
    return is_of_iteration(t, variable) &&
           inner_value_is_dead(t->facts->counted.body, t->inner, variable);
}

/** Is the node part of an update? An update writes only the element. */
static bool is_in_update(const inner_rest *t, const ir_node *node) {
    assert(ir_contains(t->block, node));
    for (; node != t->block; node = node->parent)
        if (loop_update_at(t->facts, node))
            return true;
    return false;
}

static bool may_be_written_by_call(const inner_rest *t, const ir_node *argument,
                                   const ir_type *type) {
    if ((type->kind != IR_POINTER && type->kind != IR_ARRAY) || type->target->is_const)
        return false;
    if (argument->kind == IR_UNARY && argument->op == IR_OP_ADDRESS)
        argument = argument->children[0];
    return argument->type->kind == IR_POINTER || !is_own_variable(t, expression_object(argument));
}

/** May the call write anything but variables declared in the rest? The loop's analysis has shown
 *  that the call writes only the targets of its arguments. */
static bool may_write(const inner_rest *t, const ir_node *call) {
    const ir_function *callee = call->children[0]->function;
    for (unsigned i = 1; i < call->child_count; i++) {
        const bool is_named = callee && i <= callee->parameter_count;
        const ir_node *argument = call->children[i];
        if (may_be_written_by_call(t, argument,
                                   is_named ? callee->parameters[i - 1]->type : argument->type) &&
            !(is_named && only_reads_through(callee, i - 1)))
            return true;
    }
    return !callee;
}

/** Is the node `p op= e` for a variable that is private to the iteration? If so, adds p to the
 * sums. Returns false if it is not, or if there are too many sums. */
static bool adds(inner_rest *t, const ir_node *node, const ir_variable *variable) {
    if (node->kind != IR_ASSIGN || node->op == IR_OP_NONE || !is_of_iteration(t, variable))
        return false;
    for (unsigned i = 0; i < t->sum_count; i++)
        if (t->sums[i] == variable)
            return true;
    if (t->sum_count == MOST_SUMS)
        return false;
    t->sums[t->sum_count++] = variable;
    return true;
}

static bool is_series_update(const inner_rest *t, const ir_node *node) {
    const int scalar = node->kind == IR_EXPRESSION ? scalar_update_at(t->facts, node) : -1;
    return scalar >= 0 && t->facts->scalars[scalar].is_series &&
           expression_is_plain(t->facts->scalars[scalar].value);
}

/** Does the node have an effect, other than updates, sums and series, that later iterations or
 *  statements can see? `is_inside`: a loop or switch of the rest encloses the node. */
static bool has_visible_effect(inner_rest *t, const ir_node *node, bool is_inside) {
    switch (node->kind) {
    case IR_OPAQUE:
    case IR_GOTO:
    case IR_LABEL:
    case IR_RETURN:
        return true;
    case IR_BREAK:
        return !is_inside;
    case IR_CALL:
        if (may_write(t, node))
            return true;
        break;
    default:
        break;
    }
    if (is_series_update(t, node)) { /* the leader executes the rest completely */
        t->adds_to_series = true;
        return false;
    }
    const ir_node *written = expression_written(node);
    const ir_variable *object = written ? expression_object(written) : NULL;
    if ((written || node->kind == IR_ASSIGN || ir_is_increment(node)) && !is_in_update(t, node) &&
        !(object && (is_own_variable(t, object) || is_dead(t, object) || adds(t, node, object))))
        return true;
    is_inside |= ir_is_loop(node) || node->kind == IR_SWITCH;
    for (unsigned i = 0; i < node->child_count; i++)
        if (has_visible_effect(t, node->children[i], is_inside))
            return true;
    return false;
}

/** Returns the number of floating-point operations and calls outside of updates. Updates do not
 *  count, because they have ownership checks anyway, and skipping them saves nothing. */
static unsigned work_in(const inner_rest *t, const ir_node *node) {
    if (loop_update_at(t->facts, node))
        return 0;
    unsigned work = expression_is_floating_work(node) || node->kind == IR_CALL;
    for (unsigned i = 0; i < node->child_count; i++)
        work += work_in(t, node->children[i]);
    return work;
}

static bool may_be_left_out(inner_rest *t) {
    unsigned work = 0;
    assert(t->rest < t->block->child_count);
    for (unsigned i = t->rest; i < t->block->child_count; i++) {
        if (has_visible_effect(t, t->block->children[i], false))
            return false;
        work += work_in(t, t->block->children[i]);
    }
    return work >= LEAST_WORK;
}

/* ---- where the rows are known ---------------------------------------------------------------- */

/** The number of places that give the variable a value. */
static unsigned writers_of(const ir_node *node, const ir_variable *variable) {
    const ir_node *written = expression_written(node);
    unsigned count =
        (written && expression_object(written) == variable) ||
        (node->kind == IR_DECLARATOR && node->variable == variable && node->child_count > 0);
    for (unsigned i = 0; i < node->child_count; i++)
        count += writers_of(node->children[i], variable);
    return count;
}

/** Does the variable have a value whenever an inner iteration begins? */
static bool is_set_before(const inner_rest *t, const ir_variable *variable) {
    assert(ir_contains(t->facts->counted.body, t->inner));
    const loop_facts *facts = t->facts;
    if (!private_of(facts, variable))
        return true;
    const ir_node *below = t->block;
    for (const ir_node *node = t->inner; below != facts->counted.body;
         below = node, node = node->parent) {
        if (node->kind == IR_FOR && below == ir_loop_body(node) &&
            inner_statement_sets(node->children[0], variable))
            return true;
        for (unsigned i = 0; node->kind == IR_BLOCK && node->children[i] != below; i++)
            if (inner_statement_sets(node->children[i], variable))
                return true;
    }
    return false;
}

/** Moves the beginning of the rest behind the last statement that sets the variable. Returns false
 * if the variable may have no value there, or may change before the row is updated because its
 * address is taken. */
static bool begin_after_variable(inner_rest *t, const ir_variable *variable) {
    bool is_set = is_set_before(t, variable);
    for (unsigned i = 0; i < t->block->child_count; i++) {
        is_set |= inner_statement_sets(t->block->children[i], variable);
        if (writers_of(t->block->children[i], variable) == 0)
            continue;
        if (!is_set)
            return false;
        t->rest = i + 1 > t->rest ? i + 1 : t->rest;
    }
    return is_set && !variable->address_taken;
}

static bool begin_after_variables(inner_rest *t, const ir_node *node) {
    if (node->kind == IR_VARIABLE && loop_array_of_base(t->facts, node) < 0 &&
        !begin_after_variable(t, node->variable))
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!begin_after_variables(t, node->children[i]))
            return false;
    return true;
}

static bool is_same_row(const reduction_update *a, const reduction_update *b) {
    return a->array == b->array && syntax_same(a->row, b->row);
}

/** Returns the nested loop, in the inner iteration, that steps through the update's rows; NULL if
 * there is none. */
static const loop_span *span_below(const inner_rest *t, const reduction_update *update) {
    const ir_node *const end = ir_contains(t->inner, update->statement) ? t->inner : NULL;
    for (const ir_node *node = update->statement->parent; end && node != end; node = node->parent) {
        const loop_span *span = span_of(t->facts, node);
        if (span && span_stepped_in(span, update->row))
            return span;
    }
    return NULL;
}

/** The value that the loop's header gives the variable, or NULL if another statement sets it. */
static const ir_node *first_value(const loop_span *span, const ir_variable *variable) {
    const counted_loop *counted = &span->counted;
    if (variable == counted->counter)
        return counted->lower;
    for (unsigned i = 0; i < counted->start_count; i++)
        if (counted->starts[i].variable == variable)
            return counted->starts[i].value;
    return NULL;
}

/** Moves the beginning of the rest to where the value is known. Returns false if the value is not
 * known, or if computing it reads memory or may trap. */
static bool begin_after_value(inner_rest *t, const ir_node *value) {
    return value && !expression_has_load(value, false) && !expression_has_hazard(value) &&
           begin_after_variables(t, value);
}

/** Moves the beginning of the rest to where the variable has the value from which the nested loop
 * steps it. Returns false if the variable may have no value or change later, or if the nested loop
 * is not a statement of the block itself. */
static bool begin_after_entry(inner_rest *t, const loop_span *span, const ir_variable *variable) {
    bool is_set = is_set_before(t, variable), is_behind = false;
    for (unsigned i = 0; i < t->block->child_count; i++) {
        const ir_node *statement = t->block->children[i];
        is_set |= inner_statement_sets(statement, variable);
        if (statement == span->loop) {
            is_behind = true;
        } else if (writers_of(statement, variable) > 0) {
            if (is_behind || !is_set)
                return false;
            if (t->rest <= i)
                t->rest = i + 1;
        }
    }
    return is_set && is_behind && !variable->address_taken;
}

/** Moves the beginning of the rest behind the statements that set the values on which `row`
 * depends: the nested loop's bounds, the first value of the variable that it steps, and the other
 * variables in `row`. Returns false if one of them may be unknown there. */
static bool begin_after_span(inner_rest *t, const loop_span *span, const ir_node *row) {
    const ir_variable *stepped = span_stepped_in(span, row);
    if (row->kind == IR_VARIABLE && row->variable == stepped) {
        const ir_node *first = first_value(span, stepped);
        return (first ? begin_after_value(t, first) : begin_after_entry(t, span, stepped)) &&
               begin_after_value(t, span->counted.lower) &&
               begin_after_value(t, span->counted.bound);
    }
    if (row->kind == IR_VARIABLE && loop_array_of_base(t->facts, row) < 0 &&
        !begin_after_variable(t, row->variable))
        return false;
    for (unsigned i = 0; i < row->child_count; i++)
        if (!begin_after_span(t, span, row->children[i]))
            return false;
    return true;
}

/** Adds the update's row to the rows that are checked. Returns false if there are too many rows, or
 * if this row cannot be computed before the rest. */
static bool add_row(inner_rest *t, const reduction_update *update) {
    const loop_span *span = span_below(t, update);
    for (unsigned i = 0; i < t->row_count; i++)
        if (is_same_row(t->rows[i].update, update) && t->rows[i].span == span)
            return true;
    if (t->row_count == MOST_SKIP_ROWS || update->last || update->row->type->size <= 0 ||
        expression_has_load(update->row, true) || expression_has_hazard(update->row) ||
        !(span ? begin_after_span(t, span, update->row) : begin_after_variables(t, update->row)))
        return false;
    t->rows[t->row_count++] = (skip_row){update, span};
    return true;
}

static bool find_rows(inner_rest *t) {
    const loop_facts *facts = t->facts;
    for (unsigned i = 0; i < facts->update_count; i++)
        if (ir_contains(t->inner, facts->updates[i].statement) && !add_row(t, &facts->updates[i]))
            return false;
    return t->row_count > 0 && t->rest < t->block->child_count;
}

/* ---- sums ---------------------------------------------------------------------------------- */

/** Do the row's variables have the same values in the inner iteration as at the update that reads
 * the sum? */
static bool is_fixed(const inner_rest *t, const ir_node *row) {
    const loop_facts *facts = t->facts;
    if (row->kind == IR_VARIABLE && private_of(facts, row->variable) &&
        (!is_set_before(t, row->variable) || writers_of(facts->counted.body, row->variable) > 1))
        return false;
    for (unsigned i = 0; i < row->child_count; i++)
        if (!is_fixed(t, row->children[i]))
            return false;
    return true;
}

/** Is the inner loop executed at most once in an iteration of the outer one? */
static bool is_executed_once(const inner_rest *t) {
    const ir_node *const body = t->facts->counted.body;
    for (const ir_node *node = t->inner; node != body; node = node->parent)
        if (ir_is_loop(node->parent) && node->parent != t->facts->loop)
            return false;
    return !ir_has_kind(body, IR_LABEL);
}

static bool flows_into_updates(inner_rest *t, const ir_node *node, const ir_variable *sum);

/** Like flows_into_updates, but only for the subscripts of a sum like p[c][d]. */
static bool subscripts_flow(inner_rest *t, const ir_node *target, const ir_variable *sum) {
    for (; target->kind == IR_INDEX || target->kind == IR_MEMBER; target = target->children[0])
        if (target->kind == IR_INDEX && !flows_into_updates(t, target->children[1], sum))
            return false;
    return true;
}

/** Is the sum read only by updates outside of the inner loop, and is none of these updates a store
 * that the iteration reads again (forwarded_store)? Adds the rows of these updates. */
static bool flows_into_updates(inner_rest *t, const ir_node *node, const ir_variable *sum) {
    const reduction_update *update = loop_update_at(t->facts, node);
    if (update && expression_mentions(node, sum))
        return !ir_contains(t->inner, node) && !forward_stored_by(t->facts, node) &&
               is_fixed(t, update->row) && add_row(t, update);
    if (update)
        return true;
    if (node->kind == IR_VARIABLE && node->variable == sum)
        return false;
    const ir_node *written = expression_written(node);
    const ir_node *target = written && expression_object(written) == sum ? written : NULL;
    for (unsigned i = 0; i < node->child_count; i++)
        if (node->children[i] == target ? !subscripts_flow(t, target, sum)
                                        : !flows_into_updates(t, node->children[i], sum))
            return false;
    return true;
}

static bool sums_flow_into_updates(inner_rest *t) {
    if (t->sum_count > 0 && !is_executed_once(t))
        return false;
    for (unsigned i = 0; i < t->sum_count; i++)
        if (!flows_into_updates(t, t->facts->counted.body, t->sums[i]))
            return false;
    return true;
}

/* ---- all inner loops ----------------------------------------------------------------------- */

/** Can the row's address be computed as a number, even if the program does not execute the
 *  update? */
static bool has_number(const reduction_update *update) {
    row_address address;
    return row_address_of(update->row, &address) && !row_needs_address(&address);
}

static const char *why_not(inner_rest *t) {
    if (t->block->kind != IR_BLOCK || !find_rows(t))
        return "the rows that an inner iteration updates are not known before its work";
    if (!may_be_left_out(t))
        return "the rest of an inner iteration is short, or has effects other than updates";
    if (!sums_flow_into_updates(t))
        return "a sum that an inner iteration adds to is read other than by an update";
    for (unsigned i = 0; i < t->row_count; i++)
        if (!has_number(t->rows[i].update))
            return "the address of a row cannot be computed as a number";
    return NULL;
}

typedef VECTOR(inner_skip) skip_list;

static void find_skips(const loop_plan *plan, const ir_node *node, skip_list *list) {
    if (ir_is_loop(node)) {
        inner_rest t = {.facts = plan->facts, .inner = node, .block = ir_loop_body(node)};
        inner_skip skip = {.loop = node, .declined = why_not(&t)};
        if (!skip.declined) {
            skip.before = t.block->children[t.rest];
            skip.row_count = t.row_count;
            skip.needs_leader = t.adds_to_series || plan->facts->sets_errno;
            for (unsigned i = 0; i < t.row_count; i++)
                skip.rows[i] = t.rows[i];
        }
        VECTOR_PUSH(plan->arena, list, skip);
    }
    for (unsigned i = 0; !ir_is_expression(node) && i < node->child_count; i++)
        find_skips(plan, node->children[i], list);
}

void plan_inner_skips(loop_plan *plan) {
    assert(!plan->skips);
    skip_list list = {0};
    find_skips(plan, plan->facts->counted.body, &list);
    plan->skip_count = list.count;
    plan->skips = list.items;
}

bool plan_has_leaders(const loop_plan *plan) {
    bool needs_leader = has_series(plan->facts);
    for (unsigned i = 0; i < plan->skip_count; i++)
        needs_leader |= !plan->skips[i].declined && plan->skips[i].needs_leader;
    return needs_leader;
}

const inner_skip *skip_of(const loop_plan *plan, const ir_node *loop) {
    for (unsigned i = 0; i < plan->skip_count; i++)
        if (plan->skips[i].loop == loop && !plan->skips[i].declined)
            return &plan->skips[i];
    return NULL;
}
