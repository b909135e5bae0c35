/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/memory/callee_terms.h"

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "analysis/base/row_steps.h"
#include "analysis/memory/alias.h"
#include "analysis/memory/callee_loops.h"
#include "analysis/memory/search.h"
#include "analysis/memory/value_bounds.h"

typedef struct rewriting {
    const callee_terms *terms;
    const access *item;
    callee_loops *loops; /* NULL: counters have no meaning */
    const ir_node *site; /* the place of evaluation in the function's text; NULL: the value may be
                          * another iteration's */
    bool is_exact;
    bool loads_stay; /* extent.c checks that the caller's loop does not write loaded memory */
    bool has_load;   /* an address depends on loads */
    bool loads_are_certain; /* all of them are made whenever the function is called */
    unsigned depth;
} rewriting;

static ir_node *rewrite(rewriting *r, const ir_node *node);

static ir_node *unknown_part(rewriting *r, const ir_node *node) {
    ir_node *unknown = ir_new(r->terms->memory, IR_OPAQUE, node->type, 0);
    unknown->text = "?";
    unknown->range = node->range;
    r->is_exact = false;
    return unknown;
}

/* ---- loads ----------------------------------------------------------------------------------- */

/* Does the function itself never change memory that this address computation loads? */
static bool is_stable(const rewriting *r, const ir_node *load) {
    for (unsigned i = 0; i < r->terms->raw->items.count; i++) {
        const access *store = &r->terms->raw->items.items[i];
        if (store->kind == ACCESS_READ || (store->lvalue && store->lvalue->kind == IR_VARIABLE &&
                                           variable_is_automatic(store->lvalue->variable)))
            continue;
        if (!r->terms->strict_aliasing || types_may_overlap(store->type, load->type))
            return false;
    }
    return true;
}

/* Does the node belong to this function's text, not to the access of another function? */
static bool is_of_text(const rewriting *r, const ir_node *node) {
    return r->loops && ir_contains(r->loops->body, node);
}

/* Is each local variable in it an unchanged parameter, or the counter of a loop around both nodes?
 */
static bool has_one_value(const rewriting *r, const ir_node *node, const ir_node *first,
                          const ir_node *second) {
    if (node->kind == IR_VARIABLE && variable_is_automatic(node->variable)) {
        const variable_fact *fact = variable_fact_of(r->terms->facts, node->variable);
        const bool is_fixed = node->variable->storage == IR_PARAMETER && !fact->write_count &&
                              !node->variable->address_taken;
        return is_fixed || callee_loops_share(r->loops, node->variable, first, second);
    }
    for (unsigned i = 0; i < node->child_count; i++)
        if (!has_one_value(r, node->children[i], first, second))
            return false;
    return true;
}

static bool is_member_of(const ir_node *lvalue, const ir_node *pointer) {
    return lvalue->kind == IR_MEMBER && lvalue->flags & IR_ARROW &&
           expression_same(lvalue->children[0], pointer);
}

/* Is memory at the load's address certain to be read, by this load or an equal one? A certain read
 * of another member of the same object counts as well, because it shows that the pointer is
 * valid. */
static bool is_certain_load(const rewriting *r, const ir_node *load) {
    if (callee_loops_is_certain(r->loops, load))
        return true;
    const ir_node *pointer =
        load->kind == IR_MEMBER && load->flags & IR_ARROW ? load->children[0] : NULL;
    for (unsigned i = 0; i < r->terms->raw->items.count; i++) {
        const access *other = &r->terms->raw->items.items[i];
        const bool is_alike = other->kind == ACCESS_READ && !other->callee && other->lvalue &&
                              (expression_same(other->lvalue, load) ||
                               (pointer && is_member_of(other->lvalue, pointer)));
        if (is_alike && callee_loops_is_certain(r->loops, other->node) &&
            has_one_value(r, pointer ? pointer : load, load, other->node))
            return true;
    }
    return false;
}

static void note_load(rewriting *r, const ir_node *load) {
    r->has_load = true;
    if (!r->loads_stay && !is_stable(r, load))
        r->is_exact = false;
    if (!r->loops)
        return;
    if (is_of_text(r, load))
        r->loads_are_certain &= is_certain_load(r, load);
    else /* a called function makes it, whenever it is called or in its loops */
        r->loads_are_certain &= callee_loops_is_certain(r->loops, r->item->node) &&
                                (r->item->loop_count || !r->item->is_conditional);
}

static ir_node *rewrite_value(rewriting *r, const ir_node *node) {
    if (expression_is_scalar_access(node))
        note_load(r, node);
    return rewrite(r, node);
}

/* ---- variables ------------------------------------------------------------------------------- */

/* The value converted to the type, as by an assignment to a variable. */
static ir_node *as_type(arena *a, ir_node *value, const ir_type *type) {
    if (!value->type || ir_type_equal(value->type, type) || !ir_type_is_scalar(type) ||
        type->kind == IR_POINTER)
        return value;
    ir_node *cast = ir_new(a, IR_CAST, type, 1);
    cast->range = value->range;
    cast->children[0] = value;
    value->parent = cast;
    return cast;
}

static ir_node *rewrite_definition(rewriting *r, const ir_node *node) {
    const ir_variable *variable = node->variable;
    const ir_node *value = variable_single_definition(r->terms->facts, variable);
    if (!value || r->depth > 8 || value->kind == IR_INITIALIZERS ||
        variable->type->kind == IR_ARRAY || !expression_is_plain(value))
        return unknown_part(r, node);
    const ir_node *site = r->site;
    const ir_node *place = variable_fact_of(r->terms->facts, variable)->definition_place;
    r->site = site && callee_loops_is_set_before(place, site) ? value : NULL;
    r->depth++;
    ir_node *result = as_type(r->terms->memory, rewrite_value(r, value), variable->type);
    r->depth--;
    r->site = site;
    return result;
}

static bool is_counter_of_callee(const rewriting *r, const ir_variable *variable) {
    for (unsigned i = 0; r->loops && i < r->item->loop_count; i++)
        if (r->item->loops[i].counter == variable)
            return true;
    return false;
}

static ir_node *rewrite_variable(rewriting *r, const ir_node *node) {
    const ir_variable *variable = node->variable;
    if (is_counter_of_callee(r, variable) ||
        (r->loops && callee_loops_counter(r->loops, variable, r->site)))
        return ir_substitute(r->terms->memory, node, NULL, NULL);
    if (variable->storage == IR_PARAMETER) {
        if (variable_fact_of(r->terms->facts, variable)->write_count || variable->address_taken ||
            variable->type->kind == IR_RECORD)
            return unknown_part(r, node);
        return ir_substitute(r->terms->memory, node, NULL, NULL);
    }
    if (variable->storage == IR_LOCAL)
        return rewrite_definition(r, node);
    if (variable->storage == IR_STATIC_LOCAL || variable->is_unnamed ||
        hidden_names_has(r->terms->names, variable))
        r->is_exact = false;
    return ir_substitute(r->terms->memory, node, NULL, NULL);
}

static ir_node *rewrite(rewriting *r, const ir_node *node) {
    if (node->kind == IR_VARIABLE)
        return rewrite_variable(r, node);
    const bool is_unspelled = node->kind == IR_CAST && node->type && !node->type->spelling;
    if (node->kind == IR_OPAQUE || node->kind == IR_CALL || node->kind == IR_ASSIGN || is_unspelled)
        return unknown_part(r, node);
    ir_node *copy = ir_new(r->terms->memory, node->kind, node->type, node->child_count);
    ir_node **children = copy->children;
    *copy = *node;
    copy->children = children;
    copy->parent = NULL;
    for (unsigned i = 0; i < node->child_count; i++) {
        const ir_node *child = node->children[i];
        const bool is_address = (node->kind == IR_MEMBER && !(node->flags & IR_ARROW)) ||
                                (node->kind == IR_UNARY && node->op == IR_OP_ADDRESS);
        children[i] = is_address ? rewrite(r, child) : rewrite_value(r, child);
        children[i]->parent = copy;
    }
    return copy;
}

/* ---- lvalues --------------------------------------------------------------------------------- */

/* a[k] behind a pointer, k in [0, high]: the array *(T (*)[high + 1])a. */
static ir_node *widened(rewriting *r, const ir_node *lvalue, int64_t high) {
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
    cast->children[0] = rewrite_value(r, lvalue->children[0]);
    cast->children[0]->parent = cast;
    whole->op = IR_OP_DEREFERENCE;
    whole->children[0] = cast;
    cast->parent = whole;
    return whole;
}

static ir_node *rewrite_lvalue(rewriting *r, const ir_node *lvalue) {
    const ir_node *row = access_extent(lvalue);
    int64_t low, high, constant;
    if (row->kind == IR_INDEX && row->children[0]->type->kind == IR_POINTER &&
        !expression_constant(row->children[1], &constant) &&
        counted_range(row->children[1], &low, &high) && low >= 0) {
        ir_node *whole = widened(r, row, high);
        if (whole)
            return whole;
    }
    return rewrite(r, row);
}

/* The first element that a search reads, in terms of the parameters; NULL: it is no search. */
static const ir_node *search_element(rewriting *r) {
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
    const ir_node *result = rewrite(r, element);
    return r->is_exact ? result : NULL;
}

/* ---- under the function's loops -------------------------------------------------------------- */

typedef VECTOR(source_loop) loop_list;

/* Adds the loops of this function that the rewritten row depends on, or whose trip count decides
 * whether it is read at all; outermost first. False: the bounds of one are not certain to be
 * evaluated. */
static bool add_own_loops(rewriting *r, loop_list *list) {
    source_loop found[CALLEE_MOST_LOOPS];
    unsigned count = 0;
    for (unsigned i = r->loops->count; i-- > 0;) {
        const callee_loop *own = &r->loops->items[i];
        int64_t lower, bound;
        if (own->is_constant && !own->is_used)
            continue;
        r->site = own->loop;
        found[count++] = (source_loop){.counter = own->counted.counter,
                                       .lower = rewrite_value(r, own->counted.lower),
                                       .bound = rewrite_value(r, own->counted.bound),
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

/* Adds the loops of the called function that makes the access, with bounds in its caller's terms.
 */
static void add_callee_loops(rewriting *r, loop_list *list) {
    r->site = r->item->node;
    for (unsigned i = 0; i < r->item->loop_count; i++) {
        source_loop loop = r->item->loops[i];
        loop.lower = rewrite_value(r, loop.lower);
        loop.bound = rewrite_value(r, loop.bound);
        VECTOR_PUSH(r->terms->memory, list, loop);
    }
}

/* Can the loops' rows be recorded? A loop that may end early must be the innermost one, and access
 * consecutive elements: they are recorded as one range, and the function reads its beginning. */
static bool can_be_recorded(const loop_list *list, const ir_node *row) {
    for (unsigned i = 0; i < list->count; i++)
        if (list->items[i].may_end_early &&
            (i + 1 < list->count || !source_loop_is_span(&list->items[i], row)))
            return false;
    return true;
}

/* Sets *result to the access with the loops around it; false: they are unknown. An element that is
 * not read in each iteration is recorded, too, if all expressions in it are evaluated anyway. */
static bool access_with_loops(const callee_terms *terms, const access *item, access *result) {
    callee_loops loops = callee_loops_around(terms->function, item->node);
    if (item->kind != ACCESS_READ || !item->is_exact || !loops.are_known ||
        (!loops.count && !item->loop_count))
        return false;
    rewriting r = {.terms = terms,
                   .item = item,
                   .loops = &loops,
                   .site = item->node,
                   .is_exact = true,
                   .loads_are_certain = true};
    const ir_node *row =
        item->loop_count ? rewrite(&r, item->lvalue) : rewrite_lvalue(&r, item->lvalue);
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

static bool take_terms(rewriting *r, element_bounds *all, const bound_term *terms, unsigned count) {
    for (unsigned i = 0; i < count; i++) {
        const ir_node *value = terms[i].value ? rewrite(r, terms[i].value) : NULL;
        const bound_term term = {value, terms[i].offset};
        if (element_bounds_has(all, term))
            continue;
        if (all->term_count == BOUNDS_MOST_TERMS)
            return false;
        all->terms[all->term_count++] = term;
    }
    return true;
}

static bool take_conditions(rewriting *r, element_bounds *all, const ir_node *const *values,
                            unsigned count) {
    for (unsigned i = 0; i < count; i++)
        all->conditions[all->condition_count++] = rewrite(r, values[i]);
    return r->is_exact;
}

/* The bounds of a called function's access, in this function's terms. */
static bool take_bounds_of_callee(rewriting *r, const element_bounds *theirs, element_bounds *all) {
    all->base = rewrite(r, theirs->base);
    all->element = theirs->element;
    return take_terms(r, all, theirs->terms, theirs->term_count) &&
           take_conditions(r, all, theirs->conditions, theirs->condition_count);
}

static bool take_own_bounds(rewriting *r, element_bounds *all) {
    const ir_node *row = access_extent(r->item->lvalue);
    value_bounds found;
    bounds_conditions conditions;
    if (r->item->callee || !r->item->is_exact || row->kind != IR_INDEX ||
        row->children[0]->type->kind != IR_POINTER || row->type->size <= 0 ||
        !value_bounds_of(r->terms->facts, r->terms->function, row->children[1], r->item->node,
                         &found, &conditions))
        return false;
    all->base = rewrite_value(r, row->children[0]);
    all->element = row->type;
    return take_terms(r, all, found.low, found.low_count) &&
           take_terms(r, all, found.high, found.high_count) &&
           take_conditions(r, all, conditions.value, conditions.count);
}

/* The bounds of the elements that the access may read; NULL: unknown. */
static const element_bounds *bounds_in_terms(const callee_terms *terms, const access *item) {
    rewriting r = {.terms = terms, .item = item, .is_exact = true, .loads_stay = true};
    element_bounds *all = ARENA_NEW(terms->memory, element_bounds);
    if (item->kind != ACCESS_READ || item->loop_count)
        return NULL;
    const bool is_known =
        item->bounds ? take_bounds_of_callee(&r, item->bounds, all) : take_own_bounds(&r, all);
    return is_known && r.is_exact ? all : NULL;
}

access callee_terms_of(const callee_terms *terms, const access *item) {
    access result = *item;
    rewriting r = {.terms = terms, .item = item, .is_exact = item->is_exact && !item->loop_count};
    result.from = result.to = NULL;
    result.bounds = NULL;
    result.loop_count = 0;
    result.lvalue = rewrite_lvalue(&r, item->lvalue);
    result.is_exact = r.is_exact;
    if ((r.is_exact && !(item->is_conditional && r.has_load)) ||
        access_with_loops(terms, item, &result) || r.is_exact)
        return result;
    result.from = search_element(&r);
    result.bounds = result.from ? NULL : bounds_in_terms(terms, item);
    return result;
}
