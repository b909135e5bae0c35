/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* All loops of a unit: which are judged, in which order, and what is said of them. */
#include <stdlib.h>
#include <string.h>

#include "analysis/analyser.h"
#include "analysis/candidate.h"
#include "analysis/expression.h"
#include "analysis/reason.h"
#include "analysis/scalars.h"
#include "analysis/variation.h"

/* ---- reasons ----------------------------------------------------------------------------------
 */

bool judgement_refuse(judgement *j, reason_id why, const ir_node *node, const char *name) {
    if (j->why.id != REASON_NONE)
        return false;
    ir_range range = node ? node->range : j->loop->range;
    if (range.begin >= range.end)
        range = j->loop->range;
    j->why = reason_make(j->an->memory, why, name ? name : "?", range);
    return false;
}

const char *judgement_name(const judgement *j, const ir_node *lvalue) {
    if (!lvalue)
        return "?";
    location where = location_of(j->an->facts, lvalue, j->loop);
    if (where.base)
        return expression_text(j->an->memory, where.base);
    const ir_variable *root = ir_root_variable(lvalue);
    return root ? root->name : expression_text(j->an->memory, lvalue);
}

const char *reduction_operator_spelling(reduction_operator op) {
    static const char *const spellings[] = {
        [REDUCTION_SUM] = "+",       [REDUCTION_PRODUCT] = "*", [REDUCTION_MINIMUM] = "min",
        [REDUCTION_MAXIMUM] = "max", [REDUCTION_AND] = "&",     [REDUCTION_OR] = "|",
        [REDUCTION_XOR] = "^",       [REDUCTION_NONE] = NULL};
    return spellings[op];
}

/* ---- one loop ---------------------------------------------------------------------------------
 */

/* Are all scalars of the record of this one type, so that its bytes are elements throughout? */
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

/* Do all scalars of the type lie at multiples of their own size, if what is of the type lies at
 * multiples of `grain`? Not so in packed records, and complex numbers need not. */
static bool lies_evenly(const ir_type *type, int64_t grain) {
    const ir_type *inner = ir_type_innermost(type);
    if (inner != type)
        grain = greatest_divisor(grain, inner->size);
    if (inner->kind != IR_RECORD)
        return inner->size > 0 && grain % inner->size == 0;
    for (unsigned i = 0; i < inner->record->field_count; i++) {
        const ir_field *field = &inner->record->fields[i];
        const bool is_open = field->type->kind == IR_ARRAY && field->type->count < 0;
        if (!field->is_bit_field && !is_open &&
            !lies_evenly(field->type, greatest_divisor(grain, field->offset)))
            return false;
    }
    return true;
}

/* Owners are cut between units: no element may lie across such a cut, or it would have two owners
 * where another array overlaps with it. Of records like that the unit is all of one. */
static int64_t unit_without_split(const ir_type *row, int64_t unit) {
    const ir_type *record = ir_type_innermost(row);
    if (record->kind != IR_RECORD || record->size <= unit || lies_evenly(record, record->size))
        return unit;
    return record->size;
}

/* What is made of a base on the way to its elements: b[i], *(b + i), (*b).x. */
static bool leads_on(const ir_node *parent, const ir_node *node) {
    const bool is_left = parent->child_count > 0 && parent->children[0] == node;
    const bool is_pointer = node->type->kind == IR_POINTER || node->type->kind == IR_ARRAY;
    if (parent->kind == IR_BINARY)
        return is_pointer && parent->type->kind == IR_POINTER;
    return is_left && (parent->kind == IR_INDEX || parent->kind == IR_MEMBER ||
                       (parent->kind == IR_UNARY && parent->op == IR_OP_DEREFERENCE));
}

bool judgement_has_address_as_value(const ir_node *node, const ir_node *base) {
    for (unsigned i = 0; i < node->child_count; i++)
        if (judgement_has_address_as_value(node->children[i], base))
            return true;
    if (!ir_is_expression(node) || !node->type || !expression_same(node, base))
        return false;
    while (node->parent && ir_is_expression(node->parent) && node->parent->type &&
           leads_on(node->parent, node))
        node = node->parent;
    const ir_node *user = node->parent;
    const bool is_taken = user->kind == IR_UNARY && user->op == IR_OP_ADDRESS;
    const bool is_address = node->type->kind == IR_POINTER || node->type->kind == IR_ARRAY;
    if (is_taken)
        user = user->parent;
    return (is_taken || is_address) && user->kind != IR_CALL;
}

static void finish_arrays(judgement *j, loop_facts *facts) {
    reduction_array *arrays = ARENA_ARRAY(j->an->memory, reduction_array, j->arrays.count + 1);
    for (unsigned i = 0; i < j->arrays.count; i++) {
        arrays[i] = j->arrays.items[i].array;
        const ir_type *base = arrays[i].base->type;
        if (arrays[i].is_scattered) { /* its rows do not lie in step with each other */
            arrays[i].unit = arrays[i].element->size;
            arrays[i].is_interleaved = true;
            continue;
        }
        /* in a private copy it would be another */
        arrays[i].order_is_kept |= judgement_has_address_as_value(j->loop, arrays[i].base);
        if (base && base->target && !is_homogeneous(base->target, arrays[i].element))
            arrays[i].is_interleaved = true;
        if (base && base->target)
            arrays[i].unit = unit_without_split(base->target, arrays[i].unit);
    }
    facts->arrays = arrays;
    facts->array_count = j->arrays.count;
}

/* Of a refused loop: what irregular updates there are, as far as they can be told. */
static void note_irregular_arrays(judgement *j) {
    access_list list = {0};
    access_collect(j->an->effects, j->loop, &list);
    for (unsigned i = 0; i < list.items.count; i++) {
        const access *a = &list.items.items[i];
        if (a->kind != ACCESS_UPDATE || a->callee || !a->form.has_operator || !a->lvalue->type ||
            !variation_is_irregular(j->an->facts, j->loop, a->lvalue))
            continue;
        location where = location_of(j->an->facts, a->lvalue, j->loop);
        const ir_node *base = where.base ? where.base : a->lvalue;
        bool is_known = false;
        for (unsigned k = 0; k < j->arrays.count; k++)
            is_known |= expression_same(j->arrays.items[k].array.base, base);
        if (is_known)
            continue;
        judged_array item = {.where = where};
        item.array = (reduction_array){.base = base,
                                       .name = expression_text(j->an->memory, base),
                                       .element = a->lvalue->type,
                                       .op = a->form.op};
        VECTOR_PUSH(j->an->memory, &j->arrays, item);
    }
}

static loop_facts *finish_facts(judgement *j) {
    loop_facts *facts = ARENA_NEW(j->an->memory, loop_facts);
    facts->loop = j->loop;
    facts->function = j->function;
    facts->counted = j->counted;
    finish_arrays(j, facts);
    if (j->why.id != REASON_NONE)
        return facts;
    facts->counter_is_live_after = j->counter_is_live_after;
    facts->updates = j->updates.items;
    facts->update_count = j->updates.count;
    facts->scalars = j->scalars.items;
    facts->scalar_count = j->scalars.count;
    facts->forwards = j->forwards.items;
    facts->forward_count = j->forwards.count;
    facts->sources = j->sources.items;
    facts->source_count = j->sources.count;
    facts->privates = j->privates.items;
    facts->private_count = j->privates.count;
    facts->captured = j->captured.items;
    facts->captured_count = j->captured.count;
    facts->in_slice = j->in_slice;
    facts->slice_has_floating_work = j->slice_has_floating_work;
    facts->has_inspector = true;
    facts->is_verifiable = j->is_verifiable;
    facts->key = j->key.items;
    facts->key_count = j->key.count;
    return facts;
}

static bool judge_header(judgement *j) {
    counted_result counted = counted_recognise(j->loop);
    if (!counted.is_counted)
        return judgement_refuse(j, counted.why, counted.node, counted.name);
    j->counted = counted.loop;
    return true;
}

/* With what the user says of this loop alone. */
static const analyser *analyser_for(const analyser *an, const ir_node *loop) {
    if (!pragma_above(an->pragmas, loop, PRAGMA_INDEPENDENT))
        return an;
    analyser *own = ARENA_NEW(an->memory, analyser);
    *own = *an;
    own->rules.assume_noalias = true;
    return own;
}

static loop_verdict judge(const analyser *whole, ir_function *function, ir_node *loop) {
    const analyser *an = analyser_for(whole, loop);
    judgement *j = ARENA_NEW(an->memory, judgement);
    j->an = an;
    j->function = function;
    j->loop = loop;
    bool is_fine =
        judge_text(j) && judge_jumps(j) && judge_header(j) && judge_accesses(j) && judge_updates(j);
    /* What looked like a shared array may be private to each iteration. */
    if (is_fine && j->arrays.count == 0)
        return (loop_verdict){.kind = VERDICT_NOT_A_REDUCTION, .loop = loop, .function = function};
    is_fine =
        is_fine && judge_scalars(j) && judge_privates(j) && judge_sources(j) && judge_slice(j);
    if (!is_fine) {
        j->arrays.count = 0;
        note_irregular_arrays(j);
    }
    return (loop_verdict){.kind = is_fine ? VERDICT_TRANSFORM : VERDICT_REFUSE,
                          .loop = loop,
                          .function = function,
                          .why = j->why,
                          .facts = finish_facts(j)};
}

/* ---- which loops ------------------------------------------------------------------------------
 */

typedef struct loop_search {
    const analyser *an;
    ir_function *function;
    VECTOR(loop_verdict) verdicts;
} loop_search;

/* if (R[k] < v) { ... R[k] = v; ... }: the element that is compared and stored to; or NULL. */
static const ir_node *stored_if(const ir_node *condition, const ir_node *node) {
    if (node->kind == IR_EXPRESSION)
        node = node->children[0];
    if (node->kind == IR_ASSIGN && node->children[0]->kind != IR_VARIABLE &&
        expression_occurrences(condition, node->children[0]))
        return node->children[0];
    const ir_node *found = NULL;
    for (unsigned i = 0; node->kind == IR_BLOCK && i < node->child_count && !found; i++)
        if (node->children[i]->kind == IR_EXPRESSION)
            found = stored_if(condition, node->children[i]);
    return found;
}

/* What an update looks like whose loop is listed: its target; or NULL. */
static const ir_node *updated_target(const ir_node *node) {
    if (node->kind == IR_ASSIGN || node->kind == IR_UNARY) {
        update_form form = update_form_of(node);
        if (form.is_update && form.target->kind != IR_VARIABLE)
            return form.target;
    }
    return node->kind == IR_IF ? stored_if(node->children[0], node->children[1]) : NULL;
}

/* Does the call update, through a pointer given to it, an element that is irregular in `loop`? */
static bool call_updates(const analyser *an, const ir_node *loop, const ir_node *call) {
    access_list list = {0};
    if (call->children[0]->kind != IR_FUNCTION || !call->children[0]->function->body)
        return false;
    access_collect(an->effects, call, &list);
    for (unsigned i = 0; i < list.items.count; i++) {
        const access *a = &list.items.items[i];
        if (a->callee && a->kind == ACCESS_UPDATE && a->lvalue &&
            variation_is_irregular(an->facts, loop, a->lvalue))
            return true;
    }
    return false;
}

static bool is_irregular_update(const analyser *an, const ir_node *loop, const ir_node *node) {
    if (node->kind == IR_CALL)
        return call_updates(an, loop, node);
    const ir_node *target = updated_target(node);
    if (!target || !variation_is_irregular(an->facts, loop, target))
        return false;
    const ir_variable *object = location_of(an->facts, target, loop).object;
    const ir_node *declarator = object ? variable_fact_of(an->facts, object)->declarator : NULL;
    return !declarator || !variable_is_automatic(object) || !ir_contains(loop, declarator);
}

/* Is there an update below `node` that is irregular in `loop`? With `innermost`: and in no loop
 * inside of it. */
static bool has_irregular(const analyser *an, const ir_node *loop, const ir_node *node,
                          bool innermost) {
    if (is_irregular_update(an, loop, node)) {
        if (!innermost)
            return true;
        const ir_node *inner = node->parent;
        while (inner != loop && !(ir_is_loop(inner) && is_irregular_update(an, inner, node)))
            inner = inner->parent;
        if (inner == loop)
            return true;
    }
    for (unsigned i = 0; i < node->child_count; i++)
        if (has_irregular(an, loop, node->children[i], innermost))
            return true;
    return false;
}

static bool is_inside_loop(const ir_node *loop) {
    for (const ir_node *outer = loop->parent; outer; outer = outer->parent)
        if (ir_is_loop(outer))
            return true;
    return false;
}

static bool has_irregular_loop_inside(const analyser *an, const ir_node *node) {
    for (unsigned i = 0; i < node->child_count; i++) {
        const ir_node *child = node->children[i];
        if ((ir_is_loop(child) && !candidate_is_tiny(child) &&
             has_irregular(an, child, child, false)) ||
            has_irregular_loop_inside(an, child))
            return true;
    }
    return false;
}

/* Loops of a few iterations around or inside others are not worth a parallel region, and loops that
 * only repeat what is inside have nothing to share out. */
static bool is_candidate(const analyser *an, const ir_node *loop) {
    if (candidate_is_tiny(loop) && is_inside_loop(loop))
        return false;
    if (!has_irregular_loop_inside(an, loop))
        return true;
    return !candidate_is_tiny(loop) && candidate_varies(an, loop);
}

static bool has_accepted_inside(const loop_search *s, unsigned from, const ir_node *loop) {
    for (unsigned i = from; i < s->verdicts.count; i++)
        if (s->verdicts.items[i].kind != VERDICT_NOT_A_REDUCTION &&
            ir_contains(loop, s->verdicts.items[i].loop))
            return true;
    return false;
}

static void add_not_a_reduction(loop_search *s, ir_node *loop) {
    if (!s->an->options || !s->an->options->report_all)
        return;
    loop_facts *facts = ARENA_NEW(s->an->memory, loop_facts);
    facts->loop = loop;
    facts->function = s->function;
    loop_verdict verdict = {
        .kind = VERDICT_NOT_A_REDUCTION, .loop = loop, .function = s->function, .facts = facts};
    VECTOR_PUSH(s->an->memory, &s->verdicts, verdict);
}

/* The user wants the loop left alone, and all in it. */
static void add_ignored(loop_search *s, ir_node *loop, const user_pragma *pragma) {
    judgement *j = ARENA_NEW(s->an->memory, judgement);
    j->an = s->an;
    j->function = s->function;
    j->loop = loop;
    judgement_refuse(j, REASON_IGNORED, loop,
                     arena_format(s->an->memory, "redcc %s", pragma->text));
    note_irregular_arrays(j);
    loop_verdict verdict = {.kind = VERDICT_REFUSE,
                            .loop = loop,
                            .function = s->function,
                            .why = j->why,
                            .facts = finish_facts(j)};
    VECTOR_PUSH(s->an->memory, &s->verdicts, verdict);
}

/* Judges the loops below `node`, outermost first; what is accepted covers all inside of it. */
static void search(loop_search *s, ir_node *node) {
    if (!ir_is_loop(node)) {
        for (unsigned i = 0; i < node->child_count; i++)
            search(s, node->children[i]);
        return;
    }
    bool is_irregular = has_irregular(s->an, node, node, false);
    loop_verdict verdict = {0};
    unsigned from = s->verdicts.count;
    const user_pragma *ignored = pragma_above(s->an->pragmas, node, PRAGMA_IGNORE);
    if (is_irregular && ignored) {
        add_ignored(s, node, ignored);
        return;
    }
    if (!is_irregular) {
        add_not_a_reduction(s, node);
    } else if (is_candidate(s->an, node)) {
        verdict = judge(s->an, s->function, node);
        if (verdict.kind == VERDICT_TRANSFORM) {
            VECTOR_PUSH(s->an->memory, &s->verdicts, verdict);
            return;
        }
    }
    for (unsigned i = 0; i < node->child_count; i++)
        search(s, node->children[i]);
    if (!is_irregular)
        return;
    if (verdict.loop && verdict.kind == VERDICT_NOT_A_REDUCTION) {
        add_not_a_reduction(s, node);
        return;
    }
    /* Refused: this loop is named where it is the innermost around one of its updates. (A tiny
     * loop leaves that to the loop around it.) */
    if (verdict.loop &&
        (has_irregular(s->an, node, node, true) || !has_accepted_inside(s, from, node)))
        VECTOR_PUSH(s->an->memory, &s->verdicts, verdict);
}

static int by_position(const void *a, const void *b) {
    const ir_node *x = ((const loop_verdict *)a)->loop;
    const ir_node *y = ((const loop_verdict *)b)->loop;
    if (x->range.begin != y->range.begin)
        return x->range.begin < y->range.begin ? -1 : 1;
    return x->id < y->id ? -1 : x->id > y->id;
}

static void judge_function(loop_search *s, ir_function *function) {
    unsigned from = s->verdicts.count;
    s->function = function;
    search(s, function->body);
    if (s->verdicts.count > from)
        qsort(s->verdicts.items + from, s->verdicts.count - from, sizeof(loop_verdict),
              by_position);
}

/* ---- the user's word --------------------------------------------------------------------------
 */

typedef struct pragma_use {
    const user_pragma *pragma;
    bool is_found;
} pragma_use;

static bool find_pure_call(ir_node *node, void *context) {
    pragma_use *use = context;
    use->is_found |= node->kind == IR_FUNCTION && pragma_names(use->pragma, node->function->name);
    return !use->is_found;
}

static bool concerns(const user_pragma *pragma, const ir_node *loop) {
    if (pragma->word != PRAGMA_PURE)
        return pragma->loop == loop;
    pragma_use use = {.pragma = pragma};
    ir_walk((ir_node *)loop, find_pure_call, &use);
    return use.is_found;
}

static void note_pragmas(const analyser *an, loop_verdict *verdict) {
    VECTOR(user_pragma) found = {0};
    for (unsigned i = 0; i < an->pragmas->count; i++)
        if (concerns(&an->pragmas->items[i], verdict->loop))
            VECTOR_PUSH(an->memory, &found, an->pragmas->items[i]);
    verdict->pragmas = found.items;
    verdict->pragma_count = found.count;
}

/* The options, with the functions that pragmas call pure. */
static const analysis_options *with_pragmas(arena *a, const analysis_options *options,
                                            const user_pragmas *pragmas) {
    VECTOR(const char *) pure = {0};
    for (unsigned i = 0; i < options->pure_count; i++)
        VECTOR_PUSH(a, &pure, options->pure[i]);
    for (unsigned i = 0; i < pragmas->count; i++)
        for (unsigned k = 0; k < pragmas->items[i].name_count; k++)
            if (pragmas->items[i].word == PRAGMA_PURE)
                VECTOR_PUSH(a, &pure, pragmas->items[i].names[k]);
    analysis_options *all = ARENA_NEW(a, analysis_options);
    *all = *options;
    all->pure_count = pure.count;
    all->pure = pure.items;
    return all;
}

analysis_result analyse(arena *a, const ir_unit *unit, const analysis_options *given) {
    static const analysis_options no_options;
    const user_pragmas pragmas = pragmas_of_unit(a, unit);
    const analysis_options *options = with_pragmas(a, given ? given : &no_options, &pragmas);
    must_write *prover = must_write_new(a, unit, options);
    variable_facts *facts = variable_facts_new(a, unit, prover);
    analyser an = {.memory = a,
                   .unit = unit,
                   .options = options,
                   .prover = prover,
                   .facts = facts,
                   .effects = effects_new(a, unit, options, facts),
                   .rules = {facts, unit->strict_aliasing, options->assume_noalias},
                   .text = unit_text_new(a, unit),
                   .pragmas = &pragmas};
    loop_search search_state = {.an = &an};
    for (unsigned i = 0; i < unit->function_count; i++)
        if (unit->functions[i]->body && unit->functions[i]->is_in_main_file)
            judge_function(&search_state, unit->functions[i]);
    for (unsigned i = 0; i < search_state.verdicts.count; i++)
        note_pragmas(&an, &search_state.verdicts.items[i]);
    return (analysis_result){search_state.verdicts.count, search_state.verdicts.items};
}
