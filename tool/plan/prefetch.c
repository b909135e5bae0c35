/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/prefetch.h"

#include <assert.h>

#include "plan/lookup.h"
#include "plan/work.h"
#include "support/map.h"
#include "support/vector.h"

enum {
    /* Least number of operations in an iteration for which prefetches are compiled. The runtime
     * measures whether they pay. In script/bench lanes (the drag of a fabric), all loops with
     * irregular accesses gained. With regular accesses, loops of 126 and 46 operations lost up to
     * half of their speed, and a loop of 167 operations gained as much. */
    LEAST_WORK = 12,
    /* Operations of the iterations between a prefetch and its access. */
    AWAITED = 4000,
    LEAST_AHEAD = 2,
    MOST_AHEAD = 16, /* more rows occupy too many entries of the first-level TLB */
    MOST_DEPTH = 8   /* nesting depth of calls */
};

/** Does the slice contain a loop of unknown length? Executing it twice may be too expensive. */
static bool has_open_loop(const loop_facts *facts, const ir_node *node) {
    if (ir_is_loop(node) && facts->slice.holds[node->id] && !work_constant_trip(node))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (has_open_loop(facts, node->children[i]))
            return true;
    return false;
}

/** Does the slice log reads in loops of called functions? */
static bool has_source_loop(const loop_facts *facts) {
    for (unsigned i = 0; i < facts->source_count; i++)
        if (facts->sources[i].loop_count > 0)
            return true;
    return false;
}

/* ---- gathers that the inspector need not log ------------------------------------------------ */

typedef VECTOR(gather) gather_list;

/** A call into which the search has descended. The chain of these calls traces parameters back to
 *  variables of the loop's function. */
typedef struct frame {
    const struct frame *caller; /* NULL: the loop itself */
    const ir_function *function;
    const ir_node *call;
    int depth;
} frame;

static const ir_variable *resolve(const frame *in, const ir_node *node) {
    while (node && node->kind == IR_CAST)
        node = ir_child(node, 0);
    if (!node || node->kind != IR_VARIABLE)
        return NULL;
    if (!in->caller)
        return node->variable;
    for (unsigned i = 0; i < in->function->parameter_count; i++)
        if (in->function->parameters[i] == node->variable)
            return resolve(in->caller, ir_child(in->call, i + 1));
    return NULL;
}

/** The state of the search. `visited`: the functions searched so far, each with its call depth and
 * the loop's variables that were its arguments. */
typedef struct gather_search {
    arena *arena;
    map *visited;
    gather_list list;
} gather_search;

/** Is this a new combination of function and arguments, with at least one variable of the loop? */
static bool is_new_call(gather_search *search, const frame *in) {
    assert(in->caller && in->call->kind == IR_CALL);
    const unsigned count = in->function->parameter_count;
    const size_t length = (count + 2) * sizeof(const void *);
    const void **key = arena_allocate(search->arena, length);
    bool has_variable = false;
    key[0] = in->function;
    key[1] = (const char *)in->function + in->depth; /* the depth, because deeper calls are followed
                                                      * less far */
    for (unsigned i = 0; i < count; i++) {
        key[i + 2] = resolve(in->caller, ir_child(in->call, i + 1));
        has_variable |= key[i + 2] != NULL;
    }
    if (!has_variable)
        return false;
    void **place = map_at(search->visited, key, length);
    const bool is_new = *place == NULL;
    *place = search;
    return is_new;
}

static void list_gathers(gather_search *search, const frame *in, const ir_node *node) {
    assert(in->depth <= MOST_DEPTH);
    gather_list *list = &search->list;
    if (node->kind == IR_INDEX) {
        const gather one = {resolve(in, node->children[0]), resolve(in, node->children[1])};
        bool is_new = one.base && one.subscript;
        for (unsigned i = 0; i < list->count; i++)
            is_new &= list->items[i].base != one.base || list->items[i].subscript != one.subscript;
        if (is_new)
            VECTOR_PUSH(search->arena, list, one);
    }
    if (node->kind == IR_CALL && node->children[0]->kind == IR_FUNCTION &&
        node->children[0]->function->body && !node->children[0]->function->linkage.import &&
        in->depth < MOST_DEPTH) {
        const ir_function *callee = node->children[0]->function;
        const frame inner = {in, callee, node, in->depth + 1};
        if (is_new_call(search, &inner))
            list_gathers(search, &inner, callee->body);
    }
    for (unsigned i = 0; i < node->child_count; i++)
        list_gathers(search, in, node->children[i]);
}

/** Does the slice give the variable a value in each iteration? */
static bool is_computed(const loop_facts *facts, const ir_variable *variable) {
    const ir_node *body = facts->counted.body;
    for (unsigned i = 0; body->kind == IR_BLOCK && i < body->child_count; i++) {
        const ir_node *statement = body->children[i];
        const ir_node *value = ir_child(statement, 0);
        if (statement->kind == IR_EXPRESSION && facts->slice.holds[statement->id] &&
            value->kind == IR_ASSIGN && value->op == IR_OP_NONE &&
            value->children[0]->kind == IR_VARIABLE && value->children[0]->variable == variable)
            return true;
        for (unsigned k = 0; statement->kind == IR_DECLARATION && k < statement->child_count; k++)
            if (statement->children[k]->variable == variable &&
                statement->children[k]->child_count > 0 &&
                facts->slice.holds[statement->children[k]->id])
                return true;
    }
    return false;
}

static bool is_row_of(const ir_node *row, const gather *one) {
    return row->kind == IR_INDEX && row->children[0]->kind == IR_VARIABLE &&
           row->children[0]->variable == one->base && row->children[1]->kind == IR_VARIABLE &&
           row->children[1]->variable == one->subscript;
}

static bool is_logged(const loop_facts *facts, const gather *one) {
    for (unsigned i = 0; i < facts->source_count; i++)
        if (facts->sources[i].extent == EXTENT_TOUCHED && is_row_of(facts->sources[i].row, one))
            return true;
    for (unsigned i = 0; i < facts->update_count; i++)
        if (is_row_of(facts->updates[i].row, one))
            return true;
    return false;
}

static bool is_rows(const loop_facts *facts, const ir_variable *base) {
    const ir_type *type = base->type;
    if (type->kind != IR_POINTER || !type->target || type->target->size <= 0)
        return false;
    return is_captured(facts, base);
}

static bool has_continue(const loop_facts *facts, const ir_node *node) {
    if (node->kind == IR_CONTINUE && facts->slice.holds[node->id])
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (has_continue(facts, node->children[i]))
            return true;
    return false;
}

/** Prefetches of gathers are inserted at the end of the slice. A slice with a `continue` has none,
 *  because the `continue` would skip them. */
static void plan_gathers(const loop_plan *plan, prefetch_plan *prefetch) {
    const loop_facts *facts = plan->facts;
    const frame top = {.call = facts->loop};
    gather_search search = {.arena = plan->arena, .visited = map_new(plan->arena)};
    if (has_continue(facts, facts->counted.body))
        return;
    list_gathers(&search, &top, facts->counted.body);
    gather *kept = ARENA_ARRAY(plan->arena, gather, search.list.count + 1);
    for (unsigned i = 0; i < search.list.count; i++) {
        const gather *one = &search.list.items[i];
        if (is_rows(facts, one->base) && is_computed(facts, one->subscript) &&
            !is_logged(facts, one))
            kept[prefetch->gather_count++] = *one;
    }
    prefetch->gathers = kept;
}

/* ---- all of it ----------------------------------------------------------------------------- */

static const char *why_not(const loop_facts *facts, int64_t work) {
    return facts->slice.has_floating_work ? "its subscripts depend on floating-point work, which "
                                            "may call a function that sets errno"
           : has_open_loop(facts, facts->counted.body) || has_source_loop(facts)
               ? "its subscripts are computed in a loop of unknown length"
           : work < LEAST_WORK ? "an iteration is too short"
                               : NULL;
}

void plan_prefetch(loop_plan *plan) {
    const int64_t work = plan->execution.work;
    prefetch_plan *const prefetch = &plan->prefetch;
    prefetch->declined = why_not(plan->facts, work);
    if (prefetch->declined)
        return;
    const int64_t ahead = AWAITED / work;
    prefetch->ahead = (unsigned)(ahead < LEAST_AHEAD  ? LEAST_AHEAD
                                 : ahead > MOST_AHEAD ? MOST_AHEAD
                                                      : ahead);
    prefetch->is_light = work < WORK_HEAVY;
    plan_gathers(plan, prefetch);
}
