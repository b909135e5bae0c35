/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Selects which loops of a function's nests are analysed, and which are reported. */
#include "analysis/nest.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "analysis/base/atomic_call.h"
#include "analysis/base/expression.h"
#include "analysis/base/openmp_nest.h"
#include "analysis/base/reason.h"
#include "analysis/loop/candidate.h"
#include "analysis/loop/conflict.h"
#include "analysis/loop/regular.h"
#include "analysis/memory/update_group.h"
#include "analysis/reduction/fixed_blocks.h"
#include "analysis/updating_calls.h"
#include "analysis/verdict.h"
#include "ir/ir_position.h"

/* For if (R[k] < v) { ... R[k] = v; ... }, returns the element R[k] that is compared and stored to.
 * NULL if the statement has another form. */
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

/* Does the value, as in `v[k][1] = v[k][1] + 3`, read the part of a vector that is assigned? Opaque
 * nodes count as equal here if their operands are, because this only decides whether the loop is
 * reported. */
static bool reads_opaque(const ir_node *value, const ir_node *target) {
    bool is_same = value->kind == IR_OPAQUE && value->child_count == target->child_count &&
                   target->child_count > 0;
    for (unsigned i = 0; is_same && i < value->child_count; i++)
        is_same = expression_same(value->children[i], target->children[i]);
    for (unsigned i = 0; !is_same && i < value->child_count; i++)
        is_same = reads_opaque(value->children[i], target);
    return is_same;
}

/* The target of an update, if its loop should be reported; NULL if the node is no such update. */
static const ir_node *updated_target(const analyser *an, const ir_node *node) {
    update_group group;
    if (update_group_of(an->facts, node, &group))
        return node->children[0];
    if (node->kind == IR_ASSIGN || node->kind == IR_UNARY) {
        update_form form = update_form_of(node);
        if (form.is_update && form.target->kind != IR_VARIABLE)
            return form.target;
        if (node->kind == IR_ASSIGN && form.target->kind == IR_OPAQUE && form.value &&
            reads_opaque(form.value, form.target))
            return form.target;
    }
    return node->kind == IR_IF ? stored_if(node->children[0], node->children[1]) : NULL;
}

static bool names_changed(const analyser *an, const ir_node *loop, const ir_node *node) {
    if (node->kind == IR_VARIABLE)
        return variable_is_automatic(node->variable) &&
               variable_written_in(an->facts, loop, node->variable);
    for (unsigned i = 0; i < node->child_count; i++)
        if (names_changed(an, loop, node->children[i]))
            return true;
    return false;
}

/* Does the expression update, by a call or an atomic operation, an element that several iterations
 * of `loop` may update? If it has other effects, the loop's own text must choose the element: a
 * loop over time steps is no candidate. */
static bool call_updates(const analyser *an, const ir_node *loop, const ir_node *node,
                         const access_list *list) {
    for (unsigned i = 0; i < list->items.count; i++) {
        const access *a = &list->items.items[i];
        if ((a->callee || list->atomic) && a->kind == ACCESS_UPDATE && a->lvalue &&
            conflict_at(an->facts, loop, a->lvalue, node) == CONFLICT_SHARED &&
            (!list->problems.count || names_changed(an, loop, a->lvalue)))
            return true;
    }
    return false;
}

/* May the function write the target of this argument (from 0), by its parameter's type? */
static bool may_write_argument(const ir_function *function, unsigned number) {
    if (!function || number >= function->parameter_count)
        return true;
    const ir_type *type = function->parameters[number]->type;
    return !type || type->kind != IR_POINTER || !type->target || !type->target->is_const;
}

/* May the expression change, through a pointer that it receives, an element that the loop's own
 * text chooses? */
static bool may_update_argument(const analyser *an, const ir_node *loop, const ir_node *node) {
    const ir_function *function = node->kind == IR_CALL ? ir_called_function(node) : NULL;
    for (unsigned i = 0; i < node->child_count; i++) {
        const ir_node *target = atomic_pointee(an->memory, node, i);
        if (target && may_write_argument(function, i) && names_changed(an, loop, target) &&
            conflict_at(an->facts, loop, target, node) == CONFLICT_SHARED)
            return true;
    }
    return false;
}

/* Is it a call of a function of the program whose body is in another file? */
static bool is_unseen_call(const ir_node *node) {
    const ir_function *function = node->kind == IR_CALL ? ir_called_function(node) : NULL;
    return function && !function->body && !function->is_from_system &&
           strncmp(function->name, "__builtin_", 10) != 0;
}

/* Has the call or opaque expression the conflict? A report on a regular nest names the array, which
 * such an expression does not show. */
static bool has_conflict_inside(const analyser *an, const ir_node *loop, const ir_node *node,
                                conflict_kind kind) {
    access_list list = {0};
    if (kind != CONFLICT_SHARED)
        return false;
    access_collect_known(an->effects, node, &list);
    return call_updates(an, loop, node, &list) ||
           ((list.atomic || (list.problems.count && is_unseen_call(node))) &&
            may_update_argument(an, loop, node));
}

static bool has_conflict(const analyser *an, const ir_node *loop, const ir_node *node,
                         conflict_kind kind) {
    if (node->kind == IR_CALL || node->kind == IR_OPAQUE)
        return has_conflict_inside(an, loop, node, kind);
    const ir_node *target = updated_target(an, node);
    if (!target || conflict_of(an->facts, loop, target) != kind)
        return false;
    const ir_variable *object = location_of(an->facts, conflict_whole(target), loop).object;
    const ir_node *declarator = object ? variable_fact_of(an->facts, object)->declarator : NULL;
    return !declarator || !variable_is_automatic(object) || !ir_contains(loop, declarator);
}

/* Returns an update at or below `node` that has a conflict of this kind in `loop`; NULL if there is
 * none. If `innermost` is set, updates that also have the conflict in an inner loop are ignored. */
static const ir_node *find_conflict(const analyser *an, const ir_node *loop, const ir_node *node,
                                    conflict_kind kind, bool innermost) {
    if (has_conflict(an, loop, node, kind)) {
        const ir_node *inner = innermost ? node->parent : loop;
        while (inner != loop && !(ir_is_loop(inner) && has_conflict(an, inner, node, kind)))
            inner = inner->parent;
        if (inner == loop)
            return node;
    }
    const ir_node *found = NULL;
    for (unsigned i = 0; i < node->child_count && !found; i++)
        found = find_conflict(an, loop, node->children[i], kind, innermost);
    return found;
}

/* The name of an atomic operation in an update that find_conflict found; NULL if there is none. */
static const char *atomic_in(const analyser *an, const ir_node *update) {
    access_list list = {0};
    if (update->kind == IR_CALL || update->kind == IR_OPAQUE)
        access_collect(an->effects, update, &list);
    return list.atomic;
}

static bool has_irregular(const analyser *an, const ir_node *loop, const ir_node *node,
                          bool innermost) {
    return find_conflict(an, loop, node, CONFLICT_SHARED, innermost) != NULL;
}

/* The innermost loop around `loop`; NULL if there is none. */
static const ir_node *loop_around(const ir_node *loop) {
    const ir_node *outer = loop->parent;
    while (outer && !ir_is_loop(outer))
        outer = outer->parent;
    return outer;
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

/* Is the loop worth analysing as a whole? A loop of a few iterations around or inside another is
 * not worth a parallel region. A loop that only repeats inner loops has no work to distribute. */
static bool is_candidate(const analyser *an, const ir_node *loop) {
    if (candidate_is_tiny(loop) && loop_around(loop))
        return false;
    if (!has_irregular_loop_inside(an, loop))
        return true;
    return !candidate_is_tiny(loop) && candidate_varies(an, loop);
}

static bool has_reported_inside(const loop_search *s, unsigned from, const ir_node *loop) {
    for (unsigned i = from; i < s->verdicts.count; i++)
        if (s->verdicts.items[i].kind != VERDICT_NOT_A_REDUCTION &&
            ir_contains(loop, s->verdicts.items[i].loop))
            return true;
    return false;
}

/* Was a loop directly inside the refused loop accepted? The inner loop has far fewer iterations to
 * distribute at a time, so the user should learn why the outer one was refused. False if the reason
 * is REASON_TRIP_COUNT. */
static bool inner_is_accepted(const loop_search *s, unsigned from, const loop_verdict *refused) {
    for (unsigned i = from; i < s->verdicts.count; i++)
        if (s->verdicts.items[i].kind == VERDICT_TRANSFORM &&
            loop_around(s->verdicts.items[i].loop) == refused->loop)
            return refused->why.id != REASON_TRIP_COUNT;
    return false;
}

/* Was an inner loop refused because an OpenMP directive above an enclosing loop applies to both?
 * The outer loop's verdict says why the directive must stay. */
static bool inner_is_of_nest(const loop_search *s, unsigned from) {
    for (unsigned i = from; i < s->verdicts.count; i++)
        if (s->verdicts.items[i].why.id == REASON_EXISTING_OPENMP &&
            openmp_about_nest(s->an->memory, s->an->unit, s->verdicts.items[i].loop))
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

static bool is_inspected(const loop_verdict *verdict) {
    return verdict->kind == VERDICT_TRANSFORM && verdict->facts->inspector.exists;
}

static bool has_inspected(const loop_search *s, unsigned from) {
    for (unsigned i = from; i < s->verdicts.count; i++)
        if (is_inspected(&s->verdicts.items[i]))
            return true;
    return false;
}

static bool is_in_system_header(const loop_search *s, const ir_node *loop) {
    return !s->function->is_in_main_file && !ir_position_in_header(s->an->unit, loop);
}

static loop_verdict verdict_at(const loop_search *s, ir_node *loop) {
    const ir_position *at = ir_position_in_header(s->an->unit, loop);
    return at ? verdict_in_header(s->an, s->function, loop, at->file)
              : verdict_of(s->an, s->function, loop);
}

/* Analyses the loops below `node`, outer ones first. If a loop is accepted, its inner loops are not
 * analysed. */
static void search(loop_search *s, ir_node *node) {
    if (!ir_is_loop(node) || is_in_system_header(s, node)) {
        for (unsigned i = 0; i < node->child_count; i++)
            search(s, node->children[i]);
        return;
    }
    bool is_irregular = has_irregular(s->an, node, node, false);
    loop_verdict verdict = {0};
    unsigned from = s->verdicts.count;
    const user_pragma *ignored = pragma_above(s->an->pragmas, node, PRAGMA_IGNORE);
    if (is_irregular && ignored) {
        verdict = verdict_ignored(s->an, s->function, node, ignored);
        VECTOR_PUSH(s->an->memory, &s->verdicts, verdict);
        return;
    }
    const ir_node *regular =
        is_irregular ? NULL : find_conflict(s->an, node, node, CONFLICT_REGULAR, true);
    const ir_node *target = regular ? updated_target(s->an, regular) : NULL;
    if (target && !ignored && !regular_is_parallel(s->an, node, target)) {
        verdict = verdict_regular(s->an, s->function, node, regular);
        const char *advice = regular_advice(s->an, node, target);
        if (advice)
            verdict.why.advice = advice;
        VECTOR_PUSH(s->an->memory, &s->verdicts, verdict);
    } else if (!is_irregular) {
        add_not_a_reduction(s, node);
    } else if (is_candidate(s->an, node)) {
        verdict = verdict_at(s, node);
        const ir_node *update = find_conflict(s->an, node, node, CONFLICT_SHARED, false);
        const char *atomic = atomic_in(s->an, update);
        if (verdict.kind != VERDICT_TRANSFORM && verdict.why.id != REASON_EXISTING_OPENMP && atomic)
            verdict = verdict_atomic(s->an, s->function, node, update, atomic);
        if (is_inspected(&verdict)) {
            VECTOR_PUSH(s->an->memory, &s->verdicts, verdict);
            return;
        }
    }
    for (unsigned i = 0; i < node->child_count; i++)
        search(s, node->children[i]);
    if (!is_irregular)
        return;
    const bool has_no_inspector = verdict.loop && verdict.kind == VERDICT_TRANSFORM;
    if (has_no_inspector && !has_inspected(s, from)) {
        s->verdicts.count = from;
        VECTOR_PUSH(s->an->memory, &s->verdicts, verdict);
        return;
    }
    if (has_no_inspector) { /* an inner loop has an inspector, whose plan can be reused */
        verdict.kind = VERDICT_REFUSE;
        verdict.why = reason_make(s->an->memory, REASON_INDEX_EXPENSIVE,
                                  verdict.facts->arrays[0].name, node->range);
    }
    if (verdict.loop && verdict.kind == VERDICT_NOT_A_REDUCTION) {
        add_not_a_reduction(s, node);
        return;
    }
    /* The loop is refused. It is reported if it is the innermost loop around one of its updates
     * (tiny inner loops do not count), or if it explains the verdict on an inner loop. */
    if (verdict.loop &&
        (has_irregular(s->an, node, node, true) || !has_reported_inside(s, from, node) ||
         inner_is_accepted(s, from, &verdict) || inner_is_of_nest(s, from)))
        VECTOR_PUSH(s->an->memory, &s->verdicts, verdict);
}

/* Is the loop inside a loop for which code is generated? */
static bool is_inside_rewritten(const loop_search *s, unsigned from, const ir_node *loop) {
    for (unsigned i = from; i < s->verdicts.count; i++) {
        const loop_verdict *verdict = &s->verdicts.items[i];
        if (verdict_is_written(verdict) && ir_contains(verdict->loop, loop))
            return true;
    }
    return false;
}

static bool contains_transformed(const loop_search *s, unsigned from, const ir_node *loop) {
    for (unsigned i = from; i < s->verdicts.count; i++)
        if (s->verdicts.items[i].kind == VERDICT_TRANSFORM &&
            ir_contains(loop, s->verdicts.items[i].loop))
            return true;
    return false;
}

/* Adds a verdict on a loop's scalars. If the loop has a verdict already, a new VERDICT_BLOCKS
 * replaces it, and any new verdict replaces VERDICT_NOT_A_REDUCTION. */
static void put_verdict(loop_search *s, unsigned from, loop_verdict verdict) {
    for (unsigned i = from; i < s->verdicts.count; i++)
        if (s->verdicts.items[i].loop == verdict.loop) {
            if (verdict.kind == VERDICT_BLOCKS)
                blocks_note_refusal(s->an, &verdict, &s->verdicts.items[i]);
            if (verdict.kind == VERDICT_BLOCKS ||
                s->verdicts.items[i].kind == VERDICT_NOT_A_REDUCTION)
                s->verdicts.items[i] = verdict;
            return;
        }
    VECTOR_PUSH(s->an->memory, &s->verdicts, verdict);
}

/* Finds loops whose OpenMP directive reduces scalars. */
static void search_blocks(loop_search *s, unsigned from, ir_node *node) {
    loop_verdict verdict;
    if (ir_is_loop(node) && !ir_position_in_header(s->an->unit, node) &&
        !is_inside_rewritten(s, from, node) && !contains_transformed(s, from, node) &&
        blocks_of_loop(s->an, s->function, node, &verdict))
        put_verdict(s, from, verdict);
    for (unsigned i = 0; i < node->child_count; i++)
        search_blocks(s, from, node->children[i]);
}

static int by_position(const void *a, const void *b) {
    const ir_node *x = ((const loop_verdict *)a)->loop;
    const ir_node *y = ((const loop_verdict *)b)->loop;
    return x->id < y->id ? -1 : x->id > y->id;
}

void check_loops(loop_search *s, ir_function *function) {
    assert(function->body);
    unsigned from = s->verdicts.count;
    s->function = function;
    search(s, function->body);
    if (function->is_in_main_file && s->an->unit->dialect.replaces_openmp &&
        !s->an->options->any_order)
        search_blocks(s, from, function->body);
    if (s->calls)
        list_updating_calls(s, from);
    if (s->verdicts.count > from)
        qsort(s->verdicts.items + from, s->verdicts.count - from, sizeof(loop_verdict),
              by_position);
}
