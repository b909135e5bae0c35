/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/overlap/extent.h"

#include <assert.h>
#include <string.h>

#include "analysis/base/counted.h"
#include "analysis/base/exact.h"
#include "analysis/base/expression.h"
#include "analysis/loop/bases.h"
#include "analysis/loop/executed.h"
#include "analysis/loop/place.h"
#include "analysis/loop/variation.h"
#include "analysis/overlap/row_address.h"
#include "analysis/reduction/update_array.h"

/* Are all subscripts in the row affine in the counter, and is everything else in it invariant? */
static bool is_affine_row(const loop_analysis *j, const ir_node *row) {
    switch (row->kind) {
    case IR_VARIABLE:
        if (row->variable == j->counted.counter) /* the pointer itself is the counter */
            return row->type->kind == IR_POINTER;
        return ir_type_is_scalar(row->type) ? variation_is_invariant(j->an->facts, j->loop, row)
                                            : variation_is_fixed(j->an->facts, j->loop, row);
    case IR_INDEX:
        if (!variation_affine(j->an->facts, j->loop, j->counted.counter, row->children[1])
                 .is_affine)
            return false;
        return is_affine_row(j, row->children[0]);
    case IR_MEMBER:
    case IR_CAST:
        return is_affine_row(j, row->children[0]);
    case IR_UNARY:
        return (row->op == IR_OP_DEREFERENCE || row->op == IR_OP_ADDRESS) &&
               is_affine_row(j, row->children[0]);
    case IR_BINARY:
        return (row->op == IR_OP_ADD || row->op == IR_OP_SUBTRACT) &&
               is_affine_row(j, row->children[0]) &&
               variation_affine(j->an->facts, j->loop, j->counted.counter, row->children[1])
                   .is_affine;
    default:
        return false;
    }
}

/* Does the row depend on a pointer that is loaded from a changing address? Then it is not monotonic
 * in the counter. */
static bool has_moving_load(const loop_analysis *j, const ir_node *row) {
    for (unsigned i = 0; i < row->child_count; i++) {
        const ir_node *child = row->children[i];
        bool is_load = child->kind != IR_VARIABLE && expression_is_lvalue(child) && child->type &&
                       child->type->kind != IR_ARRAY &&
                       !(row->kind == IR_UNARY && row->op == IR_OP_ADDRESS) &&
                       !(row->kind == IR_MEMBER && !(row->flags & IR_ARROW));
        if (is_load && (!variation_is_invariant(j->an->facts, j->loop, child) ||
                        expression_mentions(child, j->counted.counter)))
            return true;
        if (has_moving_load(j, child))
            return true;
    }
    return false;
}

static bool is_invariant_row(const loop_analysis *j, const ir_node *row) {
    return variation_is_fixed(j->an->facts, j->loop, row) &&
           !expression_mentions(row, j->counted.counter);
}

/* Is the base of a source an invariant pointer, or an object with an invariant address? */
static bool is_fixed_base(const loop_analysis *j, const ir_node *base) {
    if (expression_mentions(base, j->counted.counter))
        return false;
    return base->type && ir_type_is_scalar(base->type)
               ? variation_is_invariant(j->an->facts, j->loop, base) ||
                     (base->type->kind != IR_POINTER &&
                      variation_is_fixed(j->an->facts, j->loop, base))
               : variation_is_fixed(j->an->facts, j->loop, base);
}

static bool can_be_spelled(const loop_analysis *j, const ir_node *row) {
    return strcmp(expression_text(j->an->memory, row), "...") != 0 && expression_is_plain(row);
}

/* The initial value of a pointer that each iteration steps; NULL if it is no such pointer. */
static const ir_node *first_of_steps(const loop_analysis *j, const ir_node *base) {
    if (base->kind != IR_VARIABLE || base->type->kind != IR_POINTER)
        return NULL;
    if (base->variable == j->counted.counter)
        return j->counted.lower ? j->counted.lower : base;
    for (unsigned i = 0; i < j->privates.count; i++) {
        const private_variable *item = &j->privates.items[i];
        if (item->variable == base->variable && item->is_stepped)
            return item->entry ? item->entry : base;
    }
    return NULL;
}

static bool is_private(const loop_analysis *j, const ir_variable *variable) {
    for (unsigned i = 0; i < j->privates.count; i++)
        if (j->privates.items[i].variable == variable)
            return !j->privates.items[i].is_stepped;
    return false;
}

/* The only value that the loop gives to a private pointer, which iterations write before reading
 * it; NULL if it is no such pointer. */
static const ir_node *only_value(const loop_analysis *j, const ir_node *base) {
    const ir_node *only = NULL;
    if (base->kind != IR_VARIABLE || base->type->kind != IR_POINTER ||
        base->variable->address_taken || base->variable->has_other_name ||
        !is_private(j, base->variable))
        return NULL;
    const variable_fact *fact = variable_fact_of(j->an->facts, base->variable);
    for (unsigned i = 0; i < fact->writes.count; i++)
        if (ir_contains(j->loop, fact->writes.items[i])) {
            if (only)
                return NULL;
            only = fact->writes.items[i];
        }
    if (only && only->kind == IR_DECLARATOR)
        return only->children[0];
    return only && only->kind == IR_ASSIGN && only->op == IR_OP_NONE ? only->children[1] : NULL;
}

/* The pointer variable w of a value w, w + e, w - e or &w[e]; NULL for another value. */
static const ir_node *pointer_in(const ir_node *value) {
    while (value && value->type && value->type->kind == IR_POINTER && value->kind != IR_VARIABLE) {
        const bool is_address = value->kind == IR_UNARY && value->op == IR_OP_ADDRESS &&
                                value->children[0]->kind == IR_INDEX;
        const ir_node *sum = is_address ? value->children[0] : value;
        if (!is_address &&
            !(value->kind == IR_BINARY && (value->op == IR_OP_ADD || value->op == IR_OP_SUBTRACT)))
            return NULL;
        value = sum->children[sum->children[0]->type->kind == IR_POINTER ? 0 : 1];
    }
    return value && value->type && value->type->kind == IR_POINTER ? value : NULL;
}

/* The base of the read's address, as it is before the loop; NULL if it is unknown. A private
 * pointer that is set to another pointer plus an amount has the base of that other pointer. */
static const ir_node *base_before(const loop_analysis *j, const ir_node *base) {
    enum { MOST_COPIES = 8 };
    const ir_node *first = is_fixed_base(j, base) ? base : first_of_steps(j, base);
    for (unsigned i = 0; !first && base && i < MOST_COPIES; i++) {
        base = pointer_in(only_value(j, base));
        first = base && is_fixed_base(j, base) ? base : base ? first_of_steps(j, base) : NULL;
    }
    return first && can_be_spelled(j, first) ? first : NULL;
}

/* Can the address of `row` be computed before the loop? It can if each iteration computes it
 * anyway, or if it is computed from variables by operations that cannot fail. */
static bool is_safe_before(const loop_access *read, const ir_node *row) {
    return !read->access.is_conditional || slice_is_safe_anywhere(row);
}

/* Returns the row itself or, for a bit-field, which has no address, the enclosing object. Returns
 * NULL for a bit-field that is reached by ->. Also returns NULL for a bit-field if `of_contents` is
 * set, because the object contains bytes that are not read. */
static const ir_node *extent_of_bit_field(const ir_node *row, bool of_contents) {
    if (row->kind != IR_MEMBER || !row->field || !row->field->is_bit_field)
        return row;
    return of_contents || row->flags & IR_ARROW ? NULL : row->children[0];
}

static bool may_fall_below(const row_address *address, const ir_variable *counter) {
    for (unsigned i = 0; i < address->term_count; i++)
        if (exact_may_wrap(address->terms[i].subscript, counter) &&
            exact_may_fall_below(address->terms[i].subscript, counter))
            return true;
    return false;
}

static bool may_wrap(const row_address *address, const ir_variable *counter) {
    for (unsigned i = 0; i < address->term_count; i++)
        if (exact_may_wrap(address->terms[i].subscript, counter))
            return true;
    return false;
}

static bool subscripts_may_wrap(const ir_node *row, const ir_variable *counter) {
    if (row->type && row->type->kind == IR_INTEGER)
        return exact_may_wrap(row, counter);
    for (unsigned i = 0; i < row->child_count; i++)
        if (subscripts_may_wrap(row->children[i], counter))
            return true;
    return false;
}

/* Plans a row that is monotonic in the counter, by its first and last address. Iterations that do
 * not read the row may give the subscript any value, as in `x[t - 1]` where t is 0. Returns false
 * if the ends cannot be checked for wrap-around. Also returns false if such a subscript may fall
 * below its range, no condition on the counter is known, and the inspector can record the reads
 * instead. */
static bool plan_affine(const loop_analysis *j, const loop_access *read, bool can_be_recorded,
                        source_plan *plan) {
    const ir_variable *counter = j->counted.counter;
    loop_source *item = &plan->source;
    row_address address;
    const bool is_known = row_address_of(item->row, &address);
    item->extent = EXTENT_AFFINE;
    item->is_sometimes = read->access.is_conditional || j->left_out.exits;
    item->is_checked = item->is_sometimes || (is_known ? may_wrap(&address, counter)
                                                       : subscripts_may_wrap(item->row, counter));
    if (item->is_checked && (!is_known || counter->type->kind == IR_POINTER))
        return false;
    if (item->is_sometimes)
        item->limit_count = executed_limits(j, read->access.node, &item->limits);
    return !item->is_sometimes || item->limit_count || !can_be_recorded ||
           !may_fall_below(&address, counter);
}

/* Plans a row whose range is known without the inspector. Returns false if it is not known. */
static bool plan_known(const loop_analysis *j, const loop_access *read, bool can_be_recorded,
                       source_plan *plan) {
    row_address address;
    plan->is_possible = true;
    plan->source.extent = EXTENT_INVARIANT;
    plan->source.is_sometimes = read->access.is_conditional;
    if (is_invariant_row(j, plan->source.row))
        return !plan->source.is_sometimes || row_address_of(plan->source.row, &address);
    return !(j->left_out.exits && j->left_out.exits->open) && /* the last iteration is unknown */
           is_affine_row(j, plan->source.row) && plan_affine(j, read, can_be_recorded, plan);
}

/* Is the expression made of variables that the loop does not change, of loads, and of counters of
 * the callee's loops? */
static bool is_same_in_each(const loop_analysis *j, const loop_source *item, const ir_node *node) {
    if (node->kind == IR_CALL || node->kind == IR_OPAQUE || expression_written(node))
        return false;
    for (unsigned i = 0; node->kind == IR_VARIABLE && i < item->loop_count; i++)
        if (item->loops[i].counter == node->variable)
            return true;
    for (unsigned i = 0; node->kind == IR_VARIABLE && i < j->privates.count; i++)
        if (j->privates.items[i].variable == node->variable)
            return false;
    if (node->kind == IR_VARIABLE)
        return ir_type_is_scalar(node->type) ? variation_is_invariant(j->an->facts, j->loop, node)
                                             : variation_is_fixed(j->an->facts, j->loop, node);
    for (unsigned i = 0; i < node->child_count; i++)
        if (!is_same_in_each(j, item, node->children[i]))
            return false;
    return true;
}

static bool is_repeated(const loop_analysis *j, const loop_source *item) {
    bool is_same =
        item->place && executed_in_each(j, item->place) && is_same_in_each(j, item, item->row);
    for (unsigned i = 0; i < item->loop_count; i++)
        is_same = is_same && is_same_in_each(j, item, item->loops[i].lower) &&
                  is_same_in_each(j, item, item->loops[i].bound);
    return is_same;
}

/* Plans a row whose address the inspector records. */
static source_plan plan_touched(const loop_analysis *j, const loop_access *read, loop_source item,
                                bool of_contents) {
    const ir_node *node = read->access.node;
    const ir_node *place = slice_place(j, node);
    item.extent = EXTENT_TOUCHED;
    item.place = place;
    item.is_ahead = read->access.is_behind || (place && slice_is_ahead(node, place));
    item.is_repeated = is_repeated(j, &item);
    if (read->access.is_behind && !item.loop_count && !slice_is_safe_here(j, item.row, true))
        return (source_plan){false, item}; /* the row may not exist if the call does not read
                                            * it */
    const bool is_safe = item.base
                             ? !read->access.is_conditional || base_can_be_read_before(j, item.base)
                             : !of_contents && update_table_of(j, read->where.base);
    return (source_plan){is_safe && slice_can_record(j, &item, node, place), item};
}

/* Does the row consist of n elements behind a pointer, *(T (*)[n])p (callee_terms.c), of which an
 * execution may read fewer than n? The object may end after the elements that are read. */
static bool may_reach_beyond(const loop_access *read, const ir_node *row) {
    return read->access.is_conditional && row->kind == IR_UNARY && row->type->kind == IR_ARRAY &&
           row->children[0]->kind == IR_CAST;
}

/* ---- between bounds -------------------------------------------------------------------------- */

/* Is the loaded memory not written by the loop, except through arrays and scalars with which the
 * read is compared at run time? */
static bool is_not_written(const loop_analysis *j, const ir_node *load) {
    const location where = location_of(j->an->facts, load, j->loop);
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *other = &j->accesses[i];
        if (other->access.kind != ACCESS_READ && other->class != CLASS_REDUCTION &&
            !other->is_scalar &&
            locations_overlap(&j->an->rules, &where, &other->where) != OVERLAP_NO)
            return false;
    }
    return true;
}

/* Can the value be loaded before the loop? The load must not fault even if the program never makes
 * it, and must give the value that it has in the loop. */
static bool can_be_read_before(const loop_analysis *j, const ir_node *node) {
    const ir_type *type = node->type;
    if (!type || type->is_volatile || type->is_atomic || type->has_address_space)
        return false;
    switch (node->kind) {
    case IR_NUMBER:
        return node->flags & IR_HAS_VALUE;
    case IR_VARIABLE:
        return variable_is_automatic(node->variable) && !node->variable->address_taken;
    case IR_CAST:
        return type->spelling && ir_type_is_scalar(type) &&
               can_be_read_before(j, node->children[0]);
    case IR_MEMBER:
        if (!node->field || node->field->is_bit_field || node->field->offset < 0 ||
            (ir_type_is_scalar(type) && !is_not_written(j, node)))
            return false;
        return (node->flags & IR_ARROW || node->children[0]->kind == IR_MEMBER) &&
               can_be_read_before(j, node->children[0]);
    default:
        return false;
    }
}

static bool is_bound(const loop_analysis *j, const ir_node *node) {
    return variation_is_invariant(j->an->facts, j->loop, node) &&
           !expression_mentions(node, j->counted.counter) && can_be_read_before(j, node);
}

/* The row *base, which stands for the whole table in loop_source.row. */
static const ir_node *first_element(const loop_analysis *j, const element_bounds *bounds) {
    ir_node *row = ir_new(j->an->memory, IR_UNARY, bounds->element, 1);
    row->op = IR_OP_DEREFERENCE;
    row->children[0] = ir_substitute(j->an->memory, bounds->base, NULL, NULL);
    row->children[0]->parent = row;
    return row;
}

/* Plans a table whose subscript has known bounds. */
static source_plan plan_bounded(const loop_analysis *j, const element_bounds *bounds) {
    bool is_possible = is_bound(j, bounds->base);
    for (unsigned i = 0; i < bounds->term_count; i++)
        is_possible &= !bounds->terms[i].value || is_bound(j, bounds->terms[i].value);
    for (unsigned i = 0; i < bounds->condition_count; i++)
        is_possible &= is_bound(j, bounds->conditions[i]);
    return (source_plan){is_possible,
                         {.name = expression_text(j->an->memory, bounds->base),
                          .base = bounds->base,
                          .row = first_element(j, bounds),
                          .extent = EXTENT_BOUNDED,
                          .bounds = bounds}};
}

/* Does a constant loop around the node, which is a variable, count it by steps of 1 or -1? */
static bool takes_each_value(const ir_node *node) {
    const ir_node *loop = counted_constant_around(node, NULL, node->variable).loop;
    ir_variable *stepped;
    int64_t step;
    return loop && counted_step(loop->children[2], &stepped, &step) && (step == 1 || step == -1);
}

/* Is the subscript c, c + k or c - k, with a constant k and the counter c of a constant loop that
 * takes each value between its least and its greatest? */
static bool is_counter_and_constant(const ir_node *subscript) {
    int64_t value;
    if (subscript->kind == IR_BINARY &&
        (subscript->op == IR_OP_ADD || subscript->op == IR_OP_SUBTRACT))
        return subscript->children[0]->kind == IR_VARIABLE &&
               takes_each_value(subscript->children[0]) &&
               expression_constant(subscript->children[1], &value);
    return subscript->kind == IR_VARIABLE && takes_each_value(subscript);
}

/* Returns the bounds of rows if inner loops over constants read all of them in each iteration, as
 * in `for (c = 0; c < 24; c++) ... centre[c][k]`. NULL if the read has another form. */
static const element_bounds *constant_bounds(const loop_analysis *j, const loop_access *read,
                                             const ir_node *row) {
    bound_term low = {0}, high = {0};
    if (read->access.is_conditional || read->access.loop_count || row->kind != IR_INDEX ||
        !ir_contains(j->loop, row) || row->children[0]->type->kind != IR_POINTER ||
        row->type->size <= 0 || !is_counter_and_constant(row->children[1]) ||
        !counted_range(row->children[1], &low.offset, &high.offset))
        return NULL;
    assert(low.offset <= high.offset);
    element_bounds *bounds = ARENA_NEW(j->an->memory, element_bounds);
    *bounds = (element_bounds){.base = row->children[0],
                               .element = row->type,
                               .term_count = 2,
                               .terms = {low, high},
                               .is_certain = true};
    return bounds;
}

source_plan source_plan_of(const loop_analysis *j, const loop_access *read, bool of_contents) {
    source_plan plan = {0};
    if (read->access.bounds && !of_contents)
        return plan_bounded(j, read->access.bounds);
    if (!read->access.lvalue || !read->access.is_exact || !read->where.base ||
        read->where.is_of_locale)
        return plan;
    const ir_node *row = extent_of_bit_field(access_extent(read->access.lvalue), of_contents);
    if (!row || !can_be_spelled(j, row) || !row->type || row->type->kind == IR_OTHER_TYPE)
        return plan;
    if (of_contents && may_reach_beyond(read, row))
        return plan;
    const ir_node *base = read->where.base;
    plan.source = (loop_source){.name = expression_text(j->an->memory, base),
                                .base = base_before(j, base),
                                .row = row,
                                .loop_count = read->access.loop_count,
                                .loops = read->access.loops};
    const source_plan touched = plan_touched(j, read, plan.source, of_contents);
    bool is_certain = !of_contents || !read->access.is_conditional;
    if (is_certain && !read->access.loop_count && is_safe_before(read, row) &&
        !has_moving_load(j, row) && plan_known(j, read, touched.is_possible, &plan))
        return plan;
    const element_bounds *bounds = constant_bounds(j, read, row);
    const source_plan bounded = bounds ? plan_bounded(j, bounds) : touched;
    return bounded.is_possible ? bounded : touched;
}

/* Returns the variable k if the call is the value in a statement `k = find(...);` of a block. Sets
 * *after to the next statement, at which the variable has the result. NULL if the call occurs in
 * another form. */
static const ir_node *result_variable(const ir_node *call, const ir_node **after) {
    const ir_node *assignment = call->parent;
    const ir_node *statement = assignment ? assignment->parent : NULL;
    if (!statement || assignment->kind != IR_ASSIGN || assignment->op != IR_OP_NONE ||
        assignment->children[1] != call || assignment->children[0]->kind != IR_VARIABLE ||
        !ir_type_equal(assignment->children[0]->type, call->type) ||
        statement->kind != IR_EXPRESSION || !statement->parent ||
        statement->parent->kind != IR_BLOCK)
        return NULL;
    const ir_node *block = statement->parent;
    for (unsigned i = 0; i + 1 < block->child_count; i++)
        if (block->children[i] == statement) {
            *after = block->children[i + 1];
            return assignment->children[0];
        }
    return NULL;
}

/* Plans the last element that a search reads, using the variable that holds the search's result, so
 * that the inspector need not repeat the search. Returns false if there is no such variable. */
static bool plan_found(const loop_analysis *j, const loop_access *read, source_plan *plan) {
    const ir_node *after = NULL;
    const ir_node *variable = result_variable(read->access.node, &after);
    if (!variable || after->kind != IR_EXPRESSION)
        return false;
    ir_node *row = ir_substitute(j->an->memory, read->access.from, NULL, NULL);
    assert(row->kind == IR_INDEX);
    row->children[1] = ir_substitute(j->an->memory, variable, NULL, NULL);
    row->children[1]->parent = row;
    plan->source.row = row;
    plan->source.place = after;
    return slice_can_record(j, &plan->source, read->access.node, after);
}

static bool plan_search_end(const loop_analysis *j, const loop_access *read, const ir_node *row,
                            source_plan *plan) {
    const ir_node *base = read->where.base;
    const ir_node *place = slice_place(j, read->access.node);
    plan->source = (loop_source){.name = expression_text(j->an->memory, base),
                                 .base = base,
                                 .row = row,
                                 .extent = EXTENT_TOUCHED,
                                 .place = place,
                                 .is_subscript = true,
                                 .needs_guard = read->needs_guard};
    plan->is_possible = slice_can_record(j, &plan->source, read->access.node, place);
    return plan->is_possible;
}

bool source_plans_of_search(const loop_analysis *j, const loop_access *read, source_plan *first,
                            source_plan *last) {
    assert(read->access.from && read->access.to && read->access.node->kind == IR_CALL);
    const ir_node *base = read->where.base;
    const ir_node *call = read->access.node;
    if (!base || !is_fixed_base(j, base) || !can_be_spelled(j, base) ||
        !base_can_be_read_before(j, base) || !can_be_spelled(j, read->access.from))
        return false;
    for (unsigned i = 1; i < call->child_count; i++)
        if (!expression_is_plain(call->children[i]))
            return false;
    if (!plan_search_end(j, read, read->access.from, first) ||
        !plan_search_end(j, read, read->access.to, last))
        return false;
    source_plan kept = *last;
    if (plan_found(j, read, &kept))
        *last = kept;
    return true;
}
