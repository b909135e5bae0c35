/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Collects the contents of the inspector: the slice for rows and touched sources, the sources in
 * the order in which it reads them, and the key. Decides whether sources and key together show when
 * a plan may be reused. */
#include "analysis/inspector/inspection.h"

#include "analysis/base/expression.h"
#include "analysis/base/row_steps.h"
#include "analysis/inspector/slice.h"
#include "analysis/loop/bases.h"
#include "analysis/loop/executed.h"
#include "analysis/loop/own.h"
#include "analysis/loop/place.h"
#include "analysis/loop/variation.h"
#include "analysis/memory/value_bounds.h"
#include "analysis/overlap/extent.h"

typedef VECTOR(slice_touch) touch_list;

static void add_touch(const loop_analysis *j, touch_list *list, const loop_source *read) {
    const slice_touch item = {read->row, read->loop_count, read->loops, read->place};
    VECTOR_PUSH(j->an->memory, list, item);
}

/* Is the row assembled from copies of a call's arguments, as for `add(h + s[t], v)` and
 * `add_at(h, s[t], v)`? */
static bool is_assembled(const reduction_update *update) {
    return !ir_contains(update->statement, update->row);
}

static bool is_read_for_row(const reduction_update *update, const loop_access *read) {
    if (is_assembled(update))
        return read->access.lvalue && !read->access.callee &&
               ir_contains(update->statement, read->access.node) &&
               expression_occurrences(update->row, read->access.lvalue);
    return read->access.node != update->row && ir_contains(update->row, read->access.node);
}

/* Does the inspector make this access, in a statement of the slice, in its control structure, or in
 * a row? */
static bool is_in_slice(const loop_analysis *j, const bool *keep, const loop_access *read) {
    const ir_node *place = slice_place(j, read->access.node);
    if (place && keep[place->id])
        return true;
    for (unsigned i = 0; i < j->updates.count; i++)
        if (is_read_for_row(&j->updates.items[i], read))
            return true;
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *other = &j->accesses[i];
        if (!other->needs_guard || other->access.callee || other == read ||
            !ir_contains(other->access.node, read->access.node))
            continue;
        if (source_plan_of(j, other, false).source.extent == EXTENT_TOUCHED)
            return true;
    }
    return false;
}

static bool is_of_iteration(const loop_analysis *j, const location *where) {
    const ir_variable *object = where->object;
    if (!object || !variable_is_automatic(object))
        return false;
    if (object == j->counted.counter)
        return true;
    for (unsigned i = 0; i < j->privates.count; i++)
        if (j->privates.items[i].variable == object)
            return true;
    const ir_node *declarator = variable_fact_of(j->an->facts, object)->declarator;
    return declarator && ir_contains(j->loop, declarator);
}

/* Is the base passed to a function that may compute a value from it? Calls that are updates do not
 * count. */
static bool is_handed_over(const loop_analysis *j, const ir_node *node, const ir_node *base) {
    if (node->kind == IR_CALL && !analysis_is_update(j, node->parent) &&
        expression_occurrences(node, base))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (is_handed_over(j, node->children[i], base))
            return true;
    return false;
}

/* Is the lvalue the base of an array that need not be compared when a plan is reused? Plans are
 * relative to the base. But if the loop computes another value from the base, as in h[s[t] + (q -
 * h)], the base must be compared. */
static bool is_array_base(const loop_analysis *j, const ir_node *lvalue) {
    for (unsigned i = 0; i < j->arrays.count; i++)
        if (!j->arrays.items[i].array.is_scattered &&
            expression_same(j->arrays.items[i].array.base, lvalue))
            return !has_address_as_value(j->loop, lvalue) && !is_handed_over(j, j->loop, lvalue);
    return false;
}

/* Adds the value of an invariant scalar or pointer to the key. Returns false if it cannot be part
 * of the key. */
static bool add_key(loop_analysis *j, const loop_access *read) {
    const ir_node *lvalue = read->access.lvalue;
    if (read->access.callee || !lvalue->type ||
        (lvalue->type->kind != IR_INTEGER && lvalue->type->kind != IR_POINTER &&
         lvalue->type->kind != IR_BOOLEAN &&
         (lvalue->type->kind != IR_FLOATING || lvalue->type->size > 8)) ||
        !variation_is_invariant(j->an->facts, j->loop, lvalue) ||
        (read->access.is_conditional && expression_has_load(lvalue, false) &&
         !base_can_be_read_before(j, lvalue)))
        return false;
    for (unsigned i = 0; i < j->key.count; i++)
        if (expression_same(j->key.items[i], lvalue))
            return true;
    VECTOR_PUSH(j->an->memory, &j->key, lvalue);
    return true;
}

static bool is_written(const loop_analysis *j, const ir_node *statement, const ir_node *row) {
    if (row->kind == IR_VARIABLE && variable_written_in(j->an->facts, statement, row->variable))
        return true;
    for (unsigned i = 0; i < row->child_count; i++)
        if (is_written(j, statement, row->children[i]))
            return true;
    return false;
}

/* Does the row have the same address before `second` as before `first`, where the row is recorded?
 * `second` is a later statement of the same block. */
static bool stays_until(const loop_analysis *j, const ir_node *row, const ir_node *first,
                        const ir_node *second) {
    if (first == second)
        return true;
    if (!first || !second || first->parent != second->parent || first->parent->kind != IR_BLOCK)
        return false;
    const ir_node *block = first->parent;
    for (unsigned i = 0; i < block->child_count; i++) {
        const ir_node *statement = block->children[i];
        if (statement->id >= first->id && statement->id < second->id &&
            is_written(j, statement, row))
            return false;
    }
    return true;
}

static bool source_stays_until(const loop_analysis *j, const loop_source *item,
                               const ir_node *first, const ir_node *second) {
    for (unsigned i = 0; i < item->loop_count; i++)
        if (!stays_until(j, item->loops[i].lower, first, second) ||
            !stays_until(j, item->loops[i].bound, first, second))
            return false;
    return stays_until(j, item->row, first, second);
}

/* Merges bounds for the same table under the same conditions into one source. Returns false if they
 * differ, or if there are too many terms. */
static bool add_bounds(loop_analysis *j, loop_source *to, const element_bounds *more) {
    element_bounds *all = ARENA_NEW(j->an->memory, element_bounds);
    *all = *to->bounds;
    if (!ir_type_equal(all->element, more->element) ||
        all->condition_count != more->condition_count)
        return false;
    for (unsigned i = 0; i < more->condition_count; i++)
        if (!expression_same(all->conditions[i], more->conditions[i]))
            return false;
    for (unsigned i = 0; i < more->term_count; i++) {
        if (element_bounds_has(all, more->terms[i]))
            continue;
        if (all->term_count == BOUNDS_MOST_TERMS)
            return false;
        all->terms[all->term_count++] = more->terms[i];
    }
    to->bounds = all;
    return true;
}

static void add_source(loop_analysis *j, const loop_source *item) {
    for (unsigned i = 0; i < j->sources.count; i++) {
        loop_source *other = &j->sources.items[i];
        if (other->extent != item->extent || !source_rows_equal(other, item) ||
            !source_stays_until(j, item, other->place, item->place) ||
            other->is_subscript != item->is_subscript || !source_ends_equal(other, item) ||
            (item->bounds && !add_bounds(j, other, item->bounds)))
            continue;
        other->needs_guard |= item->needs_guard;
        other->is_scalar |= item->is_scalar;
        other->meets_scalars |= item->meets_scalars;
        other->meets_arrays |= item->meets_arrays;
        other->is_ahead |= item->is_ahead;
        return;
    }
    VECTOR_PUSH(j->an->memory, &j->sources, *item);
}

/* Adds the first and the last element that a callee's search reads. Returns false if they cannot be
 * recorded. */
static bool add_search(loop_analysis *j, const loop_access *read) {
    source_plan first, last;
    if (!read->access.to || !source_plans_of_search(j, read, &first, &last))
        return false;
    add_source(j, &first.source);
    add_source(j, &last.source);
    return true;
}

static void add_read(loop_analysis *j, const loop_access *read, bool is_subscript);

/* Notes that no plan can be kept, because the read determines subscripts, and its values in a later
 * execution cannot be compared with those of this one. */
static void keep_no_plan(loop_analysis *j, const ir_node *lvalue, const ir_node *node) {
    if (j->slice.is_verifiable)
        j->slice.unkept = (unkept_read){analysis_name(j, lvalue), node->range};
    j->slice.is_verifiable = false;
}

/* Is it the lvalue `whole`, or an element or member inside it? */
static bool is_within(const ir_node *lvalue, const ir_node *whole) {
    while (!expression_same(lvalue, whole)) {
        const ir_node *child = lvalue->child_count ? lvalue->children[0] : NULL;
        const bool is_part =
            child && ((lvalue->kind == IR_INDEX && child->type && child->type->kind == IR_ARRAY) ||
                      (lvalue->kind == IR_MEMBER && !(lvalue->flags & IR_ARROW)));
        if (!is_part)
            return false;
        lvalue = child;
    }
    return true;
}

/* A read that includes this load, perhaps with further bytes; NULL if there is none. */
static const loop_access *read_of(const loop_analysis *j, const ir_node *lvalue) {
    for (unsigned i = 0; i < j->access_count; i++) {
        const access *a = &j->accesses[i].access;
        if (a->kind == ACCESS_READ && a->lvalue && a->is_exact && !a->loop_count &&
            is_within(lvalue, a->lvalue))
            return &j->accesses[i];
    }
    return NULL;
}

/* A row whose address the inspector records, and depends on loads. `recorded` is the row's source.
 * `read` is the access if a callee makes it, and NULL if the row is that of an update. */
typedef struct recorded_loads {
    const loop_source *recorded;
    const loop_access *read;
} recorded_loads;

/* Adds the load `node`, from which a callee's read gets its address. The load is executed in those
 * loops of the callee whose counters it mentions, and in the loops around these. */
static void add_load_in_loops(loop_analysis *j, const ir_node *node, const recorded_loads *of) {
    loop_access load = *of->read;
    load.access.lvalue = node;
    load.access.type = node->type;
    load.access.is_behind = false;
    load.where = location_of(j->an->facts, node, j->loop);
    /* these flags apply only to the row of the read itself */
    load.needs_guard = load.meets_scalars = load.meets_arrays = false;
    while (load.access.loop_count &&
           !expression_mentions(node, of->recorded->loops[load.access.loop_count - 1].counter))
        load.access.loop_count--;
    add_read(j, &load, true);
}

static void add_load(loop_analysis *j, const ir_node *node, const recorded_loads *of) {
    if (!expression_is_scalar_access(node))
        return;
    const loop_access *load = read_of(j, node);
    if (load && load->class != CLASS_FORWARDED)
        add_read(j, load, true);
    else if (!load && of->read && of->read->access.loop_count)
        add_load_in_loops(j, node, of);
    else if (!load)
        keep_no_plan(j, node, node);
}

static void add_loads_below(loop_analysis *j, const ir_node *row, const recorded_loads *of) {
    for (unsigned i = 0; i < row->child_count; i++) {
        add_load(j, row->children[i], of);
        add_loads_below(j, row->children[i], of);
    }
}

/* Adds the loads that determine the addresses of the recorded row. While a plan is kept, their
 * values must not change. */
static void add_loads_of(loop_analysis *j, const loop_source *recorded, const loop_access *read) {
    const recorded_loads of = {recorded, read};
    add_loads_below(j, recorded->row, &of);
    for (unsigned i = 0; i < recorded->loop_count; i++) {
        add_load(j, recorded->loops[i].lower, &of);
        add_loads_below(j, recorded->loops[i].lower, &of);
        add_load(j, recorded->loops[i].bound, &of);
        add_loads_below(j, recorded->loops[i].bound, &of);
    }
}

/* Adds the read. If it determines subscripts, it goes into the key or the compared sources. If it
 * needs a guard, it goes into the guarded sources. */
static void add_read(loop_analysis *j, const loop_access *read, bool is_subscript) {
    source_plan contents = {0};
    bool is_keyed = false;
    if (is_subscript && j->slice.has_rows && !is_of_iteration(j, &read->where)) {
        is_keyed =
            read->access.lvalue && (is_array_base(j, read->access.lvalue) || add_key(j, read));
        if (!is_keyed)
            contents = source_plan_of(j, read, true);
        if (!is_keyed && !contents.is_possible && !add_search(j, read))
            keep_no_plan(j, read->access.lvalue, read->access.node);
    }
    if (contents.is_possible) {
        contents.source.is_subscript = true;
        contents.source.needs_guard = read->needs_guard;
        contents.source.meets_scalars = read->meets_scalars;
        contents.source.meets_arrays = read->meets_arrays;
        contents.source.is_scalar = read->is_scalar;
        add_source(j, &contents.source);
    } else if (read->needs_guard) {
        source_plan plan = source_plan_of(j, read, false);
        plan.source.needs_guard = true;
        plan.source.meets_scalars = read->meets_scalars;
        plan.source.meets_arrays = read->meets_arrays;
        plan.source.is_scalar = read->is_scalar;
        if (read->access.callee && plan.source.extent == EXTENT_TOUCHED)
            add_loads_of(j, &plan.source, read);
        add_source(j, &plan.source);
    }
}

/* Does the slice need the value that the own element has at the beginning of an iteration? */
static bool own_is_read_in_slice(const loop_analysis *j, const loop_access *read) {
    const own_element *own = &j->own.items[own_named(j, read->access.lvalue)];
    return own->is_in_slice && !own->is_stored_first;
}

static void add_sources(loop_analysis *j, const bool *keep) {
    j->slice.is_verifiable = true;
    j->slice.unkept = (unkept_read){0};
    j->sources.count = 0;
    j->key.count = 0;
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *read = &j->accesses[i];
        const bool is_own = read->access.kind == ACCESS_READ && read->class != CLASS_FORWARDED &&
                            read->access.lvalue && own_named(j, read->access.lvalue) >= 0;
        if (is_own) /* the read of the element at the beginning of an iteration */
            add_read(j, read, own_is_read_in_slice(j, read));
        else if (read->is_scalar)
            add_read(j, read, false);
        else if (read->access.kind == ACCESS_READ && read->class != CLASS_FORWARDED)
            add_read(j, read, is_in_slice(j, keep, read));
    }
    for (unsigned i = 0; i < j->updates.count && j->slice.has_rows; i++)
        if (is_assembled(&j->updates.items[i]))
            add_loads_of(j, &(loop_source){.row = j->updates.items[i].row}, NULL);
}

static bool set_slice(loop_analysis *j, const touch_list *touches, reason_id why,
                      const char *name) {
    slice result = slice_compute(j, touches->count, touches->items);
    if (result.obstacle)
        return analysis_refuse(j, why, result.obstacle, name);
    j->slice.holds = result.keep;
    for (unsigned i = 0; i < j->privates.count; i++) {
        private_variable *item = &j->privates.items[i];
        item->is_in_slice = false;
        for (unsigned k = 0; k < result.needed_count && item->is_stepped; k++)
            item->is_in_slice |= result.needed[k] == item->variable;
    }
    for (unsigned i = 0; i < j->own.count; i++)
        j->own.items[i].is_in_slice = result.own >> i & 1;
    j->slice.has_floating_work = result.has_floating_work;
    return true;
}

static bool is_small(const loop_analysis *j) {
    return j->sources.count <= 64;
}

static bool has_sum_in_memory(const loop_analysis *j) {
    for (unsigned i = 0; i < j->access_count; i++)
        if (j->accesses[i].is_scalar && own_named(j, j->accesses[i].access.lvalue) < 0)
            return true;
    return false;
}

/* Checks that the slice, which is executed before the loop, does not read a sum in memory, or an
 * own element of another iteration. Own elements are at known addresses, so the slice's reads at
 * known addresses are compared with them before the slice is executed. */
static bool check_scalars_unread(loop_analysis *j) {
    const bool has_sum = has_sum_in_memory(j);
    bool meets = false;
    for (unsigned i = 0; i < j->sources.count; i++)
        meets |= j->sources.items[i].is_subscript && j->sources.items[i].meets_scalars &&
                 (has_sum || j->sources.items[i].extent == EXTENT_TOUCHED);
    for (unsigned i = 0; meets && i < j->access_count; i++)
        if (j->accesses[i].is_scalar)
            return analysis_refuse(j, REASON_SCALAR_CARRIED, j->accesses[i].access.node,
                                   analysis_name(j, j->accesses[i].access.lvalue));
    return true;
}

static bool find_slice(loop_analysis *j, bool has_rows) {
    touch_list touches = {0};
    j->slice.has_rows = has_rows;
    for (unsigned i = 0; i < j->updates.count && has_rows; i++) {
        const slice_touch item = {j->updates.items[i].row, 0, NULL, j->updates.items[i].statement};
        VECTOR_PUSH(j->an->memory, &touches, item);
    }
    if (!set_slice(j, &touches, REASON_INDEX_EXPENSIVE, j->arrays.items[0].array.name))
        return false;
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *read = &j->accesses[i];
        source_plan plan = {0};
        if (read->needs_guard)
            plan = source_plan_of(j, read, false);
        if (!plan.is_possible || plan.source.extent != EXTENT_TOUCHED)
            continue;
        add_touch(j, &touches, &plan.source);
        if (!set_slice(j, &touches, REASON_MAY_ALIAS, plan.source.name))
            return false;
    }
    /* sources found in the slice are recorded at their places; computing their addresses may add
     * statements to the slice */
    bool is_stable = false;
    for (unsigned round = 0; round < 3 && !is_stable; round++) {
        const bool *before = j->slice.holds;
        add_sources(j, before);
        for (unsigned i = 0; i < j->sources.count; i++)
            if (j->sources.items[i].extent == EXTENT_TOUCHED)
                add_touch(j, &touches, &j->sources.items[i]);
        if (!set_slice(j, &touches, REASON_MAY_ALIAS, j->arrays.items[0].array.name))
            return false;
        is_stable = memcmp(before, j->slice.holds, sizeof(bool) * j->function->node_count) == 0;
    }
    add_sources(j, j->slice.holds);
    const loop_exits *exits = j->left_out.exits;
    if (exits) { /* the check before a plan is reused would make reads that the program may never
                  * make */
        j->slice.unkept = (unkept_read){.range = exits->count > 0 ? exits->items[0].statement->range
                                                                  : j->loop->range};
        j->slice.is_verifiable = false;
    }
    j->slice.is_verifiable = j->slice.is_verifiable && is_stable && has_rows;
    j->slice.has_floating_work |= !has_rows; /* only the threads' copies of the body then compute
                                              * the rows, and must agree */
    if (!check_scalars_unread(j))
        return false;
    if (!is_small(j))
        return analysis_refuse(j, REASON_MAY_ALIAS, j->loop, j->sources.items[64].name);
    return true;
}

/* Finds the slice for executions without an inspection, which only record the reads that need a
 * guard. */
static void find_slice_of_reads(loop_analysis *j) {
    touch_list touches = {0};
    for (unsigned i = 0; i < j->sources.count; i++)
        if (j->sources.items[i].extent == EXTENT_TOUCHED && j->sources.items[i].needs_guard)
            add_touch(j, &touches, &j->sources.items[i]);
    const slice result = slice_compute(j, touches.count, touches.items);
    j->slice.reads = result.obstacle ? NULL : result.keep;
}

static slice_result result_of(const loop_analysis *own) {
    return (slice_result){.why = own->why,
                          .privates = own->privates,
                          .own = own->own,
                          .sources = own->sources,
                          .key = own->key,
                          .slice = own->slice};
}

/* May two copies of the loop's text round differently, so that their subscripts differ? */
static bool may_round_differently(const loop_analysis *j) {
    return j->function->has_other_attributes || unit_text_has_own_options(j->an->text);
}

slice_result check_slice(const loop_analysis *j) {
    loop_analysis all = analysis_copy(j);
    const bool is_found = find_slice(&all, true);
    if (is_found)
        find_slice_of_reads(&all);
    if (is_found || all.why.id != REASON_INDEX_EXPENSIVE || j->left_out.exits ||
        may_round_differently(j))
        return result_of(&all);
    loop_analysis reads = analysis_copy(j);
    return result_of(find_slice(&reads, false) ? &reads : &all);
}
