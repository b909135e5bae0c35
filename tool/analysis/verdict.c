/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Analyses one loop by the checks in order, if necessary again in altered forms, and gives its
 * verdict. */
#include "analysis/verdict.h"

#include <assert.h>

#include "analysis/base/distributed.h"
#include "analysis/base/expression.h"
#include "analysis/base/inner_conditions.h"
#include "analysis/base/loop_exits.h"
#include "analysis/base/loop_loads.h"
#include "analysis/base/open_loop.h"
#include "analysis/base/openmp_loop.h"
#include "analysis/base/reason.h"
#include "analysis/inspector/inspection.h"
#include "analysis/loop/candidate.h"
#include "analysis/loop/conflict.h"
#include "analysis/loop/gate.h"
#include "analysis/loop/hulls.h"
#include "analysis/loop/loads_stay.h"
#include "analysis/loop/spans.h"
#include "analysis/overlap/sources.h"
#include "analysis/private/induction.h"
#include "analysis/private/live.h"
#include "analysis/private/privates.h"
#include "analysis/reduction/distribution.h"
#include "analysis/reduction/protection.h"
#include "analysis/reduction/scalars.h"
#include "analysis/reduction/updates.h"

/* Do all scalars in the type have the type `element`, without padding, so that all its bytes belong
 * to elements? */
static bool is_homogeneous(const ir_type *type, const ir_type *element) {
    type = ir_type_innermost(type);
    if (type->kind != IR_RECORD)
        return ir_type_equal(type, element);
    if (!type->record || !type->record->is_complete || type->record->is_union)
        return false;
    int64_t bytes = 0;
    for (unsigned i = 0; i < type->record->field_count; i++) {
        if (!is_homogeneous(type->record->fields[i].type, element))
            return false;
        bytes += type->record->fields[i].type->size;
    }
    return bytes == type->size;
}

static int64_t greatest_divisor(int64_t a, int64_t b) {
    while (b != 0) {
        const int64_t rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

/* Is each scalar in the type at a multiple of its size, if objects of the type are at multiples of
 * `grain`? False for packed records, and often for complex numbers, whose alignment is half their
 * size. */
static bool scalars_are_aligned(const ir_type *type, int64_t grain) {
    const ir_type *inner = ir_type_innermost(type);
    if (inner != type)
        grain = greatest_divisor(grain, inner->size);
    if (inner->kind != IR_RECORD)
        return inner->size > 0 && grain % inner->size == 0;
    for (unsigned i = 0; i < inner->record->field_count; i++) {
        const ir_field *field = &inner->record->fields[i];
        const bool is_open = field->type->kind == IR_ARRAY && field->type->count < 0;
        if (!field->is_bit_field && !is_open &&
            !scalars_are_aligned(field->type, greatest_divisor(grain, field->offset)))
            return false;
    }
    return true;
}

/* Returns the size of the array's unit, chosen so that no element is split. The boundaries between
 * owners' parts of memory are boundaries of units. If an element extended over a boundary, and
 * another array overlapped the element, the element would have two owners. A record with unaligned
 * scalars is therefore one unit. */
static int64_t unit_without_split(const ir_type *row, int64_t unit) {
    const ir_type *record = ir_type_innermost(row);
    if (record->kind != IR_RECORD || record->size <= unit ||
        scalars_are_aligned(record, record->size))
        return unit;
    return record->size;
}

static void finish_arrays(const loop_analysis *j, loop_facts *facts) {
    reduction_array *arrays = ARENA_ARRAY(j->an->memory, reduction_array, j->arrays.count + 1);
    for (unsigned i = 0; i < j->arrays.count; i++) {
        arrays[i] = j->arrays.items[i].array;
        const ir_type *base = arrays[i].base->type;
        if (arrays[i].is_scattered) { /* the distances between its rows are arbitrary */
            arrays[i].unit = arrays[i].element->size;
            arrays[i].is_interleaved = true;
            continue;
        }
        /* a private copy would have another address */
        arrays[i].order_is_kept |= has_address_as_value(j->loop, arrays[i].base);
        if (base && base->target && !is_homogeneous(base->target, arrays[i].element))
            arrays[i].is_interleaved = true;
        if (base && base->target)
            arrays[i].unit = unit_without_split(base->target, arrays[i].unit);
    }
    facts->arrays = arrays;
    facts->array_count = j->arrays.count;
}

/* For a refused loop, returns the arrays with updates that have a conflict of this kind, as far as
 * these arrays are known. */
static array_list arrays_of_kind(const loop_analysis *j, conflict_kind kind) {
    array_list arrays = {0};
    access_list list = {0};
    access_collect(j->an->effects, j->loop, &list);
    for (unsigned i = 0; i < list.items.count; i++) {
        const access *a = &list.items.items[i];
        if (a->kind != ACCESS_UPDATE || a->callee || !a->form.has_operator || !a->lvalue->type ||
            conflict_of(j->an->facts, j->loop, a->lvalue) != kind)
            continue;
        location where = location_of(j->an->facts, a->lvalue, j->loop);
        const ir_node *base = where.base ? where.base : a->lvalue;
        bool is_known = false;
        for (unsigned k = 0; k < arrays.count; k++)
            is_known |= expression_same(arrays.items[k].array.base, base);
        if (is_known)
            continue;
        loop_array item = {.where = where};
        item.array = (reduction_array){.base = base,
                                       .name = expression_text(j->an->memory, base),
                                       .element = a->lvalue->type,
                                       .op = a->form.op};
        VECTOR_PUSH(j->an->memory, &arrays, item);
    }
    return arrays;
}

static loop_facts *finish_facts(const loop_analysis *j) {
    loop_facts *facts = ARENA_NEW(j->an->memory, loop_facts);
    assert(ir_is_loop(j->loop) && ir_contains(j->function->body, j->loop));
    facts->loop = j->loop;
    facts->function = j->function;
    facts->counted = j->counted;
    facts->variables.openmp = j->an->openmp;
    finish_arrays(j, facts);
    if (j->why.id != REASON_NONE)
        return facts;
    facts->counter_is_live_after = j->counter_is_live_after;
    facts->sets_errno = j->found.may_set_errno && j->an->unit->dialect.math_errno;
    facts->has_short_iterations = candidate_is_short(j->an->unit, j->counted.body);
    facts->updates = j->updates.items;
    facts->update_count = j->updates.count;
    facts->scalars = j->scalars.items;
    facts->scalar_count = j->scalars.count;
    facts->forwards = j->forwards.items;
    facts->forward_count = j->forwards.count;
    facts->distribution = j->left_out.distribution;
    facts->sources = j->sources.items;
    facts->source_count = j->sources.count;
    facts->variables.privates = j->privates.items;
    facts->variables.private_count = j->privates.count;
    facts->variables.captured = j->captured.items;
    facts->variables.captured_count = j->captured.count;
    facts->variables.own = j->own.items;
    facts->variables.own_count = j->own.count;
    facts->slice.exits = j->left_out.exits;
    facts->slice.may_abort = j->found.ends.count > 0;
    facts->slice.holds = j->slice.holds;
    facts->slice.reads = j->slice.reads;
    const span_list spans = find_spans(j);
    facts->inspector.spans = spans.items;
    facts->inspector.span_count = spans.count;
    const hull_list hulls = find_hulls(j, &spans);
    facts->inspector.hulls = hulls.items;
    facts->inspector.hull_count = hulls.count;
    facts->slice.has_floating_work = j->slice.has_floating_work;
    facts->inspector.exists = facts->slice.has_rows = j->slice.has_rows;
    facts->slice.is_verifiable = j->slice.is_verifiable;
    facts->slice.unkept = j->slice.unkept;
    facts->inspector.key = j->key.items;
    facts->inspector.key_count = j->key.count;
    return facts;
}

/* ---- the checks, and the use of their results ---------------------------------------------------
 * Each check gets the facts found so far as constants. Only this file adds a check's results to
 * these facts. */

/* Sets the reason. Returns whether the check has passed, that is, found none. */
static bool passes(loop_analysis *j, reason why) {
    j->why = why;
    return why.id == REASON_NONE;
}

typedef struct header_result {
    reason why;
    counted_loop counted;
} header_result;

static header_result check_header(const loop_analysis *j) {
    const counted_result found = counted_recognise_analysed(j->loop);
    if (!found.is_counted)
        return (header_result){.why = analysis_reason(j, found.why, found.node, found.name)};
    header_result result = {.counted = found.loop};
    const ir_variable *bound = found.loop.bound_variable;
    if (bound && variable_is_live_after(j->an->facts, j->an->openmp, j->loop, bound))
        result.why = analysis_reason(j, REASON_LAST_VALUE, j->loop->children[0], bound->name);
    return result;
}

static bool add_header(loop_analysis *j) {
    const header_result found = check_header(j);
    j->counted = found.counted;
    return passes(j, found.why);
}

static bool add_accesses(loop_analysis *j) {
    const access_result result = check_accesses(j);
    j->found = result.found;
    j->access_count = result.count;
    j->accesses = result.accesses;
    return passes(j, result.why);
}

static bool add_header_steps(loop_analysis *j) {
    const uint64_t before = analysis_fingerprint(j);
    const step_result result = check_header_steps(j);
    analysis_assert_unchanged(j, before);
    j->privates = result.privates;
    return passes(j, result.why);
}

static bool add_updates(loop_analysis *j) {
    const uint64_t before = analysis_fingerprint(j);
    const update_result result = check_updates(j);
    analysis_assert_unchanged(j, before);
    j->access_count = result.access_count;
    j->accesses = result.accesses;
    j->arrays = result.arrays;
    j->updates = result.updates;
    j->scalars = result.scalars;
    j->forwards = result.forwards;
    j->own = result.own;
    j->privates = result.privates;
    return passes(j, result.why);
}

static bool add_privates(loop_analysis *j) {
    const uint64_t before = analysis_fingerprint(j);
    const private_check result = check_privates(j);
    analysis_assert_unchanged(j, before);
    j->privates = result.privates;
    j->captured = result.captured;
    j->counter_is_live_after = result.counter_is_live_after;
    return passes(j, result.why);
}

static bool add_sources(loop_analysis *j) {
    const uint64_t before = analysis_fingerprint(j);
    const source_result result = check_sources(j);
    analysis_assert_unchanged(j, before);
    j->accesses = result.accesses;
    j->arrays = result.arrays;
    return passes(j, result.why);
}

static bool add_slice(loop_analysis *j) {
    const uint64_t before = analysis_fingerprint(j);
    const slice_result result = check_slice(j);
    analysis_assert_unchanged(j, before);
    j->privates = result.privates;
    j->own = result.own;
    j->sources = result.sources;
    j->key = result.key;
    j->slice = result.slice;
    return passes(j, result.why);
}

/* A copy of the analyser, with this loop's OpenMP directives and the user's assertions about it. */
static analyser *analyser_for(const analyser *an, const ir_node *loop) {
    analyser *own = ARENA_NEW(an->memory, analyser);
    *own = *an;
    own->rules.loop = loop;
    own->openmp = openmp_of_loop(an->memory, an->unit, loop);
    own->rules.assume_noalias |= pragma_above(an->pragmas, loop, PRAGMA_INDEPENDENT) != NULL;
    return own;
}

static loop_verdict analysed(const analyser *an, ir_function *function, ir_node *loop,
                             const distribution *stores, const loop_exits *exits,
                             const loop_loads *loads) {
    loop_analysis j = {.an = an, .function = function, .loop = loop, .left_out = {stores, exits}};
    bool is_fine = passes(&j, check_text(&j)) && passes(&j, check_jumps(&j)) && add_header(&j) &&
                   add_accesses(&j) && passes(&j, check_distribution(&j)) && add_header_steps(&j) &&
                   add_updates(&j);
    /* an array that seemed to be shared may be private to each iteration */
    if (is_fine && j.arrays.count == 0)
        return (loop_verdict){.kind = VERDICT_NOT_A_REDUCTION, .loop = loop, .function = function};
    is_fine = is_fine && passes(&j, check_scalars(&j)) && add_privates(&j) && add_sources(&j) &&
              add_slice(&j) && passes(&j, check_protection(&j));
    if (!is_fine)
        j.arrays = arrays_of_kind(&j, CONFLICT_SHARED);
    loop_facts *facts = finish_facts(&j);
    facts->variables.loads = loads;
    return (loop_verdict){.kind = is_fine ? VERDICT_TRANSFORM : VERDICT_REFUSE,
                          .loop = loop,
                          .function = function,
                          .why = j.why,
                          .facts = facts};
}

/* Analyses the loop without the stores that can be made after all iterations. Returns
 * VERDICT_REFUSE if there are no such stores. */
static loop_verdict analysed_without(const analyser *an, ir_function *function, ir_node *loop) {
    loop_analysis j = {.an = an, .function = function, .loop = loop};
    const distribution *stores = add_header(&j) ? distribution_find(&j) : NULL;
    if (!stores)
        return (loop_verdict){.kind = VERDICT_REFUSE};
    distributed_take_out(stores);
    const loop_verdict found = analysed(an, function, loop, stores, NULL, NULL);
    distributed_put_back(stores);
    return found;
}

/* If `found` is a refusal that may be due to a pointer that the loop loads, analyses the loop again
 * with a variable in place of each such pointer. This may be so if a pointer is read only under
 * conditions, if its target must be known when the loop begins, or if the elements behind it may be
 * own elements. Returns `found` if none of these applies, or if the new analysis does not help. */
static loop_verdict analysed_loading(const analyser *an, ir_function *function, ir_node *loop,
                                     const loop_exits *exits, loop_verdict found) {
    const reason_id why = found.why.id;
    const bool may_be_own = why == REASON_OTHER_STORE || why == REASON_ARRAY_READ;
    if (found.kind != VERDICT_REFUSE ||
        (why != REASON_BASE_CONDITIONAL && why != REASON_MAY_ALIAS && !may_be_own))
        return found;
    const loop_loads *loads = loop_loads_find(an->memory, an->unit, function, ir_loop_body(loop));
    if (!loads || !loads_stay(an, loop, loads))
        return found;
    loop_loads_take_out(loads);
    const loop_verdict loading = analysed(an, function, loop, NULL, exits, loads);
    loop_loads_put_back(loads);
    /* The new analysis was to find own elements. If it found none, it differs from the first one
     * only in the name of the array, so its verdict is not used. */
    return may_be_own && (loading.kind != VERDICT_TRANSFORM || !loading.facts->variables.own_count)
               ? found
               : loading;
}

/* If the loop is refused for a read that cannot be compared, analyses it again with the conditions
 * of inner loops in their bodies. They stay there if the loop is accepted. */
static loop_verdict analysed_opening(const analyser *an, ir_function *function, ir_node *loop,
                                     loop_verdict found) {
    if (found.kind != VERDICT_REFUSE || found.why.id != REASON_MAY_ALIAS)
        return found;
    const inner_conditions *moved =
        inner_conditions_move(an->memory, an->unit->source, function, loop);
    if (!moved)
        return found;
    const loop_verdict opened = analysed(an, function, loop, NULL, NULL, NULL);
    if (opened.kind == VERDICT_TRANSFORM)
        return opened;
    inner_conditions_put_back(moved);
    return found;
}

/* Analyses the loop without its exits. The result is VERDICT_NOT_A_REDUCTION if one of them cannot
 * be removed. */
static loop_verdict analysed_staying(const analyser *an, ir_function *function, ir_node *loop) {
    const loop_exits *exits = loop_exits_find(an->memory, ir_loop_body(loop));
    if (!exits)
        return (loop_verdict){.kind = VERDICT_NOT_A_REDUCTION};
    loop_exits_take_out(exits);
    const loop_verdict found = analysed_loading(an, function, loop, exits,
                                                analysed(an, function, loop, NULL, exits, NULL));
    loop_exits_put_back(exits);
    return found;
}

/* Analyses a loop without a bound (open_loop_find), whose end only its data decide. Iterations must
 * be long, because one thread first evaluates the conditions of all of them. The result is
 * VERDICT_TRANSFORM or VERDICT_NOT_A_REDUCTION. */
static loop_verdict analysed_open(const analyser *an, ir_function *function, ir_node *loop) {
    const loop_verdict none = {.kind = VERDICT_NOT_A_REDUCTION};
    const loop_exits *exits = open_loop_find(an->memory, an->unit->source, function, loop);
    if (!exits)
        return none;
    loop_exits_take_out(exits);
    const bool is_short = candidate_is_short(an->unit, exits->open->block);
    const loop_verdict found = is_short ? none : analysed(an, function, loop, NULL, exits, NULL);
    loop_exits_put_back(exits);
    return found.kind == VERDICT_TRANSFORM ? found : none;
}

static bool is_about_leaving(reason_id why) {
    return why == REASON_BREAK || why == REASON_RETURN || why == REASON_GOTO ||
           why == REASON_NO_RETURN || why == REASON_IMPURE_CALL || why == REASON_OPAQUE;
}

static loop_verdict verdict_by(const analyser *an, ir_function *function, ir_node *loop) {
    const loop_verdict found = analysed_opening(
        an, function, loop,
        analysed_loading(an, function, loop, NULL, analysed(an, function, loop, NULL, NULL, NULL)));
    if (found.kind != VERDICT_REFUSE)
        return found;
    const bool may_leave = is_about_leaving(found.why.id);
    const loop_verdict staying = may_leave ? analysed_staying(an, function, loop) : found;
    if (staying.why.id == REASON_TRIP_COUNT) {
        const loop_verdict open = analysed_open(an, function, loop);
        if (open.kind == VERDICT_TRANSFORM)
            return open;
    }
    if (may_leave && staying.kind != VERDICT_NOT_A_REDUCTION)
        return staying.kind == VERDICT_TRANSFORM ||
                       (staying.facts->counted.counter && !is_about_leaving(staying.why.id))
                   ? staying
                   : found;
    const loop_verdict rest = analysed_without(an, function, loop);
    return rest.kind == VERDICT_TRANSFORM ? rest : found;
}

/* May the loop have been refused because of an access to an own element? */
static bool is_about_stores(reason_id why) {
    return why == REASON_INDEX_ARRAY_WRITTEN || why == REASON_OTHER_STORE ||
           why == REASON_ARRAY_READ || why == REASON_ARRAY_STORED;
}

loop_verdict verdict_of(const analyser *whole, ir_function *function, ir_node *loop) {
    analyser *an = analyser_for(whole, loop);
    const loop_verdict found = verdict_by(an, function, loop);
    if (found.kind != VERDICT_REFUSE || !is_about_stores(found.why.id))
        return found;
    an->keeps_own = true;
    const loop_verdict keeping = verdict_by(an, function, loop);
    an->keeps_own = false;
    return keeping.kind == VERDICT_TRANSFORM ? keeping : found;
}

static loop_verdict refused(loop_analysis *j, reason why, conflict_kind kind) {
    j->why = why;
    j->arrays = arrays_of_kind(j, kind);
    return (loop_verdict){.kind = VERDICT_REFUSE,
                          .loop = j->loop,
                          .function = j->function,
                          .why = why,
                          .facts = finish_facts(j)};
}

/* Returns the name of the array that the node `store` writes or, if the node is no assignment, its
 * text. */
static const char *name_written(const loop_analysis *j, const ir_node *store) {
    const ir_node *lvalue = expression_written(store);
    if (!lvalue)
        lvalue = store;
    const location where = location_of(j->an->facts, lvalue, j->loop);
    return expression_text(j->an->memory, where.base ? where.base : lvalue);
}

loop_verdict verdict_regular(const analyser *whole, ir_function *function, ir_node *loop,
                             const ir_node *update) {
    assert(ir_contains(loop, update));
    const analyser *an = analyser_for(whole, loop);
    loop_analysis j = {.an = an, .function = function, .loop = loop};
    const array_list arrays = arrays_of_kind(&j, CONFLICT_REGULAR);
    const char *name = arrays.count ? arrays.items[0].array.name : name_written(&j, update);
    return refused(&j, analysis_reason(&j, REASON_REGULAR_NEST, update, name), CONFLICT_REGULAR);
}

loop_verdict verdict_atomic(const analyser *whole, ir_function *function, ir_node *loop,
                            const ir_node *update, const char *name) {
    assert(ir_contains(loop, update));
    const analyser *an = analyser_for(whole, loop);
    loop_analysis j = {.an = an, .function = function, .loop = loop};
    return refused(&j, analysis_reason(&j, REASON_IMPURE_CALL, update, name), CONFLICT_SHARED);
}

loop_verdict verdict_ignored(const analyser *whole, ir_function *function, ir_node *loop,
                             const user_pragma *pragma) {
    const analyser *an = analyser_for(whole, loop);
    loop_analysis j = {.an = an, .function = function, .loop = loop};
    const char *text = arena_format(an->memory, "redcc %s", pragma->text);
    return refused(&j, analysis_reason(&j, REASON_IGNORED, loop, text), CONFLICT_SHARED);
}

loop_verdict verdict_in_header(const analyser *an, ir_function *function, ir_node *loop,
                               const char *header) {
    loop_analysis j = {.an = an, .function = function, .loop = loop};
    return refused(&j, analysis_reason(&j, REASON_IN_HEADER, loop, header), CONFLICT_SHARED);
}
