/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/memory/callee_terms.h"

#include <assert.h>

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "analysis/base/row_steps.h"
#include "analysis/memory/callee_loops.h"
#include "analysis/memory/callee_values.h"
#include "analysis/memory/search.h"
#include "analysis/memory/value_bounds.h"

/* ---- lvalues --------------------------------------------------------------------------------- */

/* For a[k], with a pointer a and k in [0, high], returns the array *(T (*)[high + 1])a. NULL if C
 * cannot spell the array's type. */
static ir_node *widened(callee_rewriting *r, const ir_node *lvalue, int64_t high) {
    assert(high >= 0 && high < INT64_MAX);
    arena *a = r->terms->memory;
    const ir_type *element = lvalue->type;
    if (!element->spelling || element->kind == IR_POINTER || element->kind == IR_ARRAY ||
        element->size <= 0)
        return NULL;
    ir_type *array = ARENA_NEW(a, ir_type);
    ir_type *pointer = ARENA_NEW(a, ir_type);
    *array = (ir_type){.kind = IR_ARRAY,
                       .count = high + 1,
                       .size = (high + 1) * element->size,
                       .target = element,
                       .spelling =
                           arena_format(a, "%s[%lld]", element->spelling, (long long)(high + 1))};
    *pointer = (ir_type){
        .kind = IR_POINTER,
        .size = (int64_t)sizeof(void *),
        .target = array,
        .spelling = arena_format(a, "%s (*)[%lld]", element->spelling, (long long)(high + 1))};
    ir_node *cast = ir_new(a, IR_CAST, pointer, 1);
    ir_node *whole = ir_new(a, IR_UNARY, array, 1);
    cast->range = whole->range = lvalue->range;
    cast->children[0] = callee_rewrite_value(r, lvalue->children[0]);
    cast->children[0]->parent = cast;
    whole->op = IR_OP_DEREFERENCE;
    whole->children[0] = cast;
    cast->parent = whole;
    return whole;
}

static ir_node *rewrite_lvalue(callee_rewriting *r, const ir_node *lvalue) {
    const ir_node *row = access_extent(lvalue);
    int64_t low, high, constant;
    if (row->kind == IR_INDEX && row->children[0]->type->kind == IR_POINTER &&
        !expression_constant(row->children[1], &constant) &&
        counted_range(row->children[1], &low, &high) && low >= 0) {
        ir_node *whole = widened(r, row, high);
        if (whole)
            return whole;
    }
    return callee_rewrite(r, row);
}

/* The first element that a linear search reads, expressed by the parameters; NULL if the access is
 * no search, or the element cannot be expressed. */
static const ir_node *search_element(callee_rewriting *r) {
    const access *item = r->item;
    const ir_node *start = item->kind == ACCESS_READ && !item->callee && item->is_exact
                               ? search_start(r->terms->function, item->lvalue)
                               : NULL;
    if (!start || item->lvalue->children[0]->type->kind != IR_POINTER)
        return NULL;
    ir_node *element = ir_new(r->terms->memory, IR_INDEX, item->lvalue->type, 2);
    element->range = item->lvalue->range;
    element->children[0] = item->lvalue->children[0];
    element->children[1] = (ir_node *)start;
    const ir_type *cursor = item->lvalue->children[1]->type;
    if (!start->type || !ir_type_equal(start->type, cursor)) {
        element->children[1] = ir_new(r->terms->memory, IR_CAST, cursor, 1);
        element->children[1]->range = start->range;
        element->children[1]->children[0] = (ir_node *)start;
    }
    r->is_exact = true;
    const ir_node *result = callee_rewrite(r, element);
    return r->is_exact ? result : NULL;
}

/* ---- under the function's loops -------------------------------------------------------------- */

typedef VECTOR(source_loop) loop_list;

/* Adds the loops of this function on which the rewritten row depends, or that decide by their trip
 * count whether the row is read at all. The outermost is added first. Returns false if one of their
 * bounds is not certain to be evaluated. */
static bool add_own_loops(callee_rewriting *r, loop_list *list) {
    source_loop found[CALLEE_MOST_LOOPS];
    unsigned count = 0;
    for (unsigned i = r->loops->count; i-- > 0;) {
        const callee_loop *own = &r->loops->items[i];
        int64_t lower, bound;
        if (own->is_constant && !own->is_used)
            continue;
        r->site = own->loop;
        found[count++] = (source_loop){.counter = own->counted.counter,
                                       .lower = callee_rewrite_value(r, own->counted.lower),
                                       .bound = callee_rewrite_value(r, own->counted.bound),
                                       .comparison = own->counted.comparison,
                                       .step = own->counted.step,
                                       .may_end_early = own->may_end_early};
        const bool is_simple = expression_constant(own->counted.lower, &lower) &&
                               expression_constant(own->counted.bound, &bound);
        if (!is_simple && !callee_loops_is_certain(r->loops, own->loop))
            return false;
    }
    while (count > 0)
        VECTOR_PUSH(r->terms->memory, list, found[--count]);
    return true;
}

/* Adds the loops of the called function that makes the access, with bounds expressed by this
 * function's variables. */
static void add_callee_loops(callee_rewriting *r, loop_list *list) {
    r->site = r->item->node;
    for (unsigned i = 0; i < r->item->loop_count; i++) {
        source_loop loop = r->item->loops[i];
        loop.lower = callee_rewrite_value(r, loop.lower);
        loop.bound = callee_rewrite_value(r, loop.bound);
        VECTOR_PUSH(r->terms->memory, list, loop);
    }
}

/* Can the rows that the loops access be recorded? A loop that may end early must be the innermost
 * and access consecutive elements. The elements of all its iterations are recorded as one range,
 * although the function may read only the first ones. */
static bool can_be_recorded(const loop_list *list, const ir_node *row) {
    for (unsigned i = 0; i < list->count; i++)
        if (list->items[i].may_end_early &&
            (i + 1 < list->count || !source_loop_is_span(&list->items[i], row)))
            return false;
    return true;
}

/* Stores in *result a read with the loops around it. Returns false if the rows cannot be recorded.
 * An iteration may skip the read (is_behind); its row is recorded too. The row's loads must then be
 * certain to happen, and it must contain no operation that may trap. */
static bool access_with_loops(const callee_terms *terms, const access *item, bool follows_changes,
                              access *result) {
    callee_loops loops =
        callee_loops_around(terms->memory, terms->facts, terms->loops, terms->function, item->node);
    if (item->kind != ACCESS_READ || !item->is_exact || !loops.are_known ||
        (!loops.count && !item->loop_count))
        return false;
    callee_rewriting r = {.terms = terms,
                          .item = item,
                          .loops = &loops,
                          .site = item->node,
                          .is_exact = true,
                          .loads_are_certain = true,
                          .follows_changes = follows_changes};
    const ir_node *row =
        item->loop_count ? callee_rewrite(&r, item->lvalue) : rewrite_lvalue(&r, item->lvalue);
    const bool loads_are_certain = r.loads_are_certain;
    loop_list list = {0};
    bool has_loops = add_own_loops(&r, &list);
    if (has_loops)
        add_callee_loops(&r, &list);
    const bool is_behind = !callee_loops_is_certain(&loops, item->node) || item->is_behind ||
                           (item->callee && !item->loop_count && item->is_conditional);
    if (!has_loops || !r.is_exact || !list.count || !loads_are_certain ||
        (is_behind && expression_has_hazard(row)) || !can_be_recorded(&list, row))
        return false;
    *result = *item;
    result->lvalue = row;
    result->loops = list.items;
    result->loop_count = list.count;
    result->is_behind = is_behind;
    return true;
}

/* ---- between bounds -------------------------------------------------------------------------- */

static bool take_terms(callee_rewriting *r, element_bounds *all, const bound_term *terms,
                       unsigned count) {
    for (unsigned i = 0; i < count; i++) {
        const ir_node *value = terms[i].value ? callee_rewrite(r, terms[i].value) : NULL;
        const bound_term term = {value, terms[i].offset};
        if (element_bounds_has(all, term))
            continue;
        if (all->term_count == BOUNDS_MOST_TERMS)
            return false;
        all->terms[all->term_count++] = term;
    }
    return true;
}

static bool take_conditions(callee_rewriting *r, element_bounds *all, const ir_node *const *values,
                            unsigned count) {
    assert(all->condition_count + count <= BOUNDS_MOST_CONDITIONS);
    for (unsigned i = 0; i < count; i++)
        all->conditions[all->condition_count++] = callee_rewrite(r, values[i]);
    return r->is_exact;
}

/* Expresses the bounds of a called function's access by this function's variables. */
static bool take_bounds_of_callee(callee_rewriting *r, const element_bounds *theirs,
                                  element_bounds *all) {
    all->base = callee_rewrite(r, theirs->base);
    all->element = theirs->element;
    return take_terms(r, all, theirs->terms, theirs->term_count) &&
           take_conditions(r, all, theirs->conditions, theirs->condition_count);
}

static bool take_own_bounds(callee_rewriting *r, element_bounds *all) {
    const ir_node *row = access_extent(r->item->lvalue);
    value_bounds found;
    bounds_conditions conditions;
    if (r->item->callee || !r->item->is_exact || row->kind != IR_INDEX ||
        row->children[0]->type->kind != IR_POINTER || row->type->size <= 0 ||
        !value_bounds_of(r->terms->facts, r->terms->function, row->children[1], r->item->node,
                         &found, &conditions))
        return false;
    all->base = callee_rewrite_value(r, row->children[0]);
    all->element = row->type;
    return take_terms(r, all, found.low, found.low_count) &&
           take_terms(r, all, found.high, found.high_count) &&
           take_conditions(r, all, conditions.value, conditions.count);
}

/* The bounds of the elements that the access may read; NULL if they are unknown. */
static const element_bounds *bounds_in_terms(const callee_terms *terms, const access *item) {
    callee_rewriting r = {.terms = terms, .item = item, .is_exact = true, .loads_stay = true};
    element_bounds *all = ARENA_NEW(terms->memory, element_bounds);
    if (item->kind != ACCESS_READ || item->loop_count)
        return NULL;
    const bool is_known =
        item->bounds ? take_bounds_of_callee(&r, item->bounds, all) : take_own_bounds(&r, all);
    return is_known && r.is_exact ? all : NULL;
}

/* Expresses the access in *result. Returns true if its address, or that of each iteration of
 * result->loops, is exact. */
static bool exact_terms(const callee_terms *terms, const access *item, bool follows_changes,
                        access *result) {
    callee_rewriting r = {.terms = terms,
                          .item = item,
                          .site = follows_changes ? item->node : NULL,
                          .is_exact = item->is_exact && !item->loop_count,
                          .follows_changes = follows_changes};
    *result = *item;
    result->from = result->to = NULL;
    result->bounds = NULL;
    result->loop_count = 0;
    result->lvalue = rewrite_lvalue(&r, item->lvalue);
    result->is_exact = r.is_exact;
    return (r.is_exact && !(item->is_conditional && r.has_load)) ||
           access_with_loops(terms, item, follows_changes, result) || r.is_exact;
}

access callee_terms_of(const callee_terms *terms, const access *item) {
    access result, followed;
    if (exact_terms(terms, item, false, &result))
        return result;
    callee_rewriting r = {.terms = terms, .item = item};
    result.from = search_element(&r);
    result.bounds = result.from ? NULL : bounds_in_terms(terms, item);
    /* bounds are preferred: with them, no iteration has to repeat the computation of the
     * subscript */
    if (item->kind == ACCESS_READ && !result.from && !result.bounds &&
        exact_terms(terms, item, true, &followed))
        return followed;
    return result;
}
