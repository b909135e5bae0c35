/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/loop/loop_analysis.h"

#include <assert.h>

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "analysis/base/reason.h"
#include "analysis/loop/conflict.h"
#include "analysis/memory/update_group.h"
#include "ir/ir_position.h"

/* Gives the list its own storage: vector_grow copies the items. An empty list needs none. */
#define OWN_LIST(a, list)                                                                          \
    do {                                                                                           \
        (list)->capacity = (list)->count;                                                          \
        if ((list)->count > 0)                                                                     \
            (list)->items =                                                                        \
                vector_grow((a), (list)->items, sizeof *(list)->items, &(list)->capacity);         \
    } while (0)

loop_analysis analysis_copy(const loop_analysis *known) {
    arena *a = known->an->memory;
    loop_analysis own = *known;
    own.accesses = ARENA_ARRAY(a, loop_access, known->access_count + 1);
    for (unsigned i = 0; i < known->access_count; i++)
        own.accesses[i] = known->accesses[i];
    OWN_LIST(a, &own.arrays);
    OWN_LIST(a, &own.updates);
    OWN_LIST(a, &own.scalars);
    OWN_LIST(a, &own.forwards);
    OWN_LIST(a, &own.privates);
    OWN_LIST(a, &own.own);
    OWN_LIST(a, &own.captured);
    OWN_LIST(a, &own.sources);
    OWN_LIST(a, &own.key);
    return own;
}

#ifdef NDEBUG

uint64_t analysis_fingerprint(const loop_analysis *known) {
    (void)known;
    return 0;
}

void analysis_assert_unchanged(const loop_analysis *known, uint64_t before) {
    (void)known;
    (void)before;
}

#else

static uint64_t hash(uint64_t before, const void *bytes, size_t size) {
    const unsigned char *at = bytes;
    for (size_t i = 0; i < size; i++)
        before = (before ^ at[i]) * 1099511628211u;
    return before;
}

#define HASH_LIST(before, list) hash((before), (list).items, (list).count * sizeof *(list).items)

uint64_t analysis_fingerprint(const loop_analysis *known) {
    uint64_t all = hash(1, known, sizeof *known);
    all = hash(all, known->accesses, known->access_count * sizeof *known->accesses);
    all = HASH_LIST(all, known->arrays);
    all = HASH_LIST(all, known->updates);
    all = HASH_LIST(all, known->scalars);
    all = HASH_LIST(all, known->forwards);
    all = HASH_LIST(all, known->privates);
    all = HASH_LIST(all, known->own);
    all = HASH_LIST(all, known->captured);
    all = HASH_LIST(all, known->sources);
    return HASH_LIST(all, known->key);
}

void analysis_assert_unchanged(const loop_analysis *known, uint64_t before) {
    assert(analysis_fingerprint(known) == before);
}

#endif

/* The loop's name in a message: by its counter, or by its line if the counter is unknown. */
static const char *loop_text(const analyser *an, ir_node *loop, const char *counter) {
    const ir_unit *unit = an->unit;
    const counted_result found = counted_recognise_analysed(loop);
    if (!counter && found.is_counted)
        counter = found.loop.counter->name;
    if (counter)
        return arena_format(an->memory, "the loop over '%s'", counter);
    const ir_position *in_header = ir_position_in_header(unit, loop);
    return arena_format(an->memory, "the loop in line %u",
                        in_header ? in_header->line : ir_position_of(unit, loop->range.begin).line);
}

const char *analysis_loop_text(const analyser *an, ir_node *loop) {
    return loop_text(an, loop, NULL);
}

static bool names_loop(reason_id why) {
    return why == REASON_TRIP_COUNT || why == REASON_BREAK || why == REASON_RETURN ||
           why == REASON_GOTO;
}

static const ir_node *condition_of(const ir_node *loop) {
    return loop->children[loop->kind == IR_WHILE ? 0 : 1];
}

/* Does the loop walk along a list: is p = p->next or p = next[p] at or below `node`, and does the
 * loop's condition depend on p? */
static bool follows_links(const ir_node *loop, const ir_node *node) {
    if (node->kind == IR_ASSIGN && node->op == IR_OP_NONE &&
        node->children[0]->kind == IR_VARIABLE && ir_is_access(node->children[1]) &&
        expression_mentions(node->children[1], node->children[0]->variable) &&
        expression_mentions(condition_of(loop), node->children[0]->variable))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (follows_links(loop, node->children[i]))
            return true;
    return false;
}

reason analysis_reason(const loop_analysis *j, reason_id why, const ir_node *node,
                       const char *name) {
    assert(why > REASON_NONE && why < REASON_COUNT);
    ir_range range = node ? node->range : j->loop->range;
    if (range.begin >= range.end)
        range = j->loop->range;
    if (names_loop(why))
        name = loop_text(j->an, j->loop, name);
    reason result = reason_make(j->an->memory, why, name ? name : "?", range);
    if (why == REASON_IMPURE_CALL && name) {
        const ir_function *function = ir_function_named(j->an->unit, name);
        result.advice = reason_advice_on_call(j->an->memory, name, function && function->body);
    }
    if ((why == REASON_STEP || why == REASON_TRIP_COUNT) && follows_links(j->loop, j->loop))
        result.advice = "store the elements of the list in an array in an earlier loop, and count "
                        "over the array";
    const ir_variable *holder = why == REASON_ARRAY_READ && node ? update_group_holder(node) : NULL;
    if (holder)
        result.advice = arena_format(j->an->memory,
                                     "if nothing else changes this element meanwhile, update it "
                                     "itself in place of '%s'",
                                     holder->name);
    return result;
}

/* The record or row of which the lvalue is a part: p[k] for p[k].v and p[k].x[2]. */
static const ir_node *record_of(const ir_node *lvalue) {
    const ir_node *outer = lvalue->child_count ? lvalue->children[0] : NULL;
    const bool is_in_row = lvalue->kind == IR_INDEX && ir_is_array(outer) &&
                           (outer->kind == IR_INDEX || outer->kind == IR_MEMBER);
    return lvalue->kind == IR_MEMBER || is_in_row ? record_of(outer) : lvalue;
}

/* Does the iteration read and update one record, as a particle that is moved, or one element that
 * no other iteration updates? */
static bool is_of_own_record(const loop_analysis *j, const loop_array *array, const ir_node *read) {
    return array->first && expression_same(record_of(array->first), record_of(read)) &&
           (read->kind == IR_MEMBER ||
            conflict_of(j->an->facts, j->loop, array->first) == CONFLICT_NONE);
}

bool analysis_refuse_read(loop_analysis *own, const loop_array *array, const ir_node *read) {
    analysis_refuse(own, REASON_ARRAY_READ, read, array->array.name);
    if (own->arrays.count > 1 && is_of_own_record(own, array, read))
        own->why.advice = arena_format(own->an->memory,
                                       "if what an iteration stores in '%s' depends on no other "
                                       "iteration, split the loop: the first one stores it, the "
                                       "second one makes the other updates",
                                       array->array.name);
    return false;
}

bool analysis_refuse(loop_analysis *own, reason_id why, const ir_node *node, const char *name) {
    if (own->why.id == REASON_NONE)
        own->why = analysis_reason(own, why, node, name);
    return false;
}

bool analysis_declares(const loop_analysis *j, const ir_variable *variable) {
    const ir_node *declarator = variable_fact_of(j->an->facts, variable)->declarator;
    return declarator && ir_contains(j->loop, declarator);
}

const loop_start *analysis_start_of(const loop_analysis *j, const ir_variable *variable) {
    for (unsigned i = 0; i < j->counted.start_count; i++)
        if (j->counted.starts[i].variable == variable)
            return &j->counted.starts[i];
    return NULL;
}

bool analysis_header_declares(const loop_analysis *j, const ir_variable *variable) {
    const loop_start *start = analysis_start_of(j, variable);
    return start && start->is_declared && variable->type->spelling;
}

bool analysis_is_unchanged(const loop_analysis *j, const ir_node *node) {
    return node->kind == IR_VARIABLE && variable_is_automatic(node->variable) &&
           !node->variable->address_taken && !node->type->is_volatile &&
           node->variable != j->counted.counter &&
           !variable_written_in(j->an->facts, j->loop, node->variable);
}

bool analysis_is_fixed(const loop_analysis *j, const ir_node *node) {
    return node->kind == IR_NUMBER || analysis_is_unchanged(j, node);
}

bool analysis_is_update(const loop_analysis *j, const ir_node *statement) {
    for (unsigned i = 0; i < j->updates.count; i++)
        if (j->updates.items[i].statement == statement)
            return true;
    return false;
}

const char *analysis_name(const loop_analysis *j, const ir_node *lvalue) {
    if (!lvalue)
        return "?";
    location where = location_of(j->an->facts, lvalue, j->loop);
    if (where.base)
        return expression_text(j->an->memory, where.base);
    const ir_variable *root = ir_root_variable(lvalue);
    return root ? root->name : expression_text(j->an->memory, lvalue);
}

/* Is `parent` a step from a base towards its elements: b[i], *(b + i), (*b).x? */
static bool is_step_to_element(const ir_node *parent, const ir_node *node) {
    const bool is_left = parent->child_count > 0 && parent->children[0] == node;
    const bool is_pointer = node->type->kind == IR_POINTER || node->type->kind == IR_ARRAY;
    if (parent->kind == IR_BINARY)
        return is_pointer && parent->type->kind == IR_POINTER;
    return is_left && (parent->kind == IR_INDEX || parent->kind == IR_MEMBER ||
                       (parent->kind == IR_UNARY && parent->op == IR_OP_DEREFERENCE));
}

bool has_address_as_value(const ir_node *node, const ir_node *base) {
    for (unsigned i = 0; i < node->child_count; i++)
        if (has_address_as_value(node->children[i], base))
            return true;
    if (!ir_is_expression(node) || !node->type || !expression_same(node, base))
        return false;
    while (node->parent && ir_is_expression(node->parent) && node->parent->type &&
           is_step_to_element(node->parent, node))
        node = node->parent;
    const ir_node *user = node->parent;
    const bool is_taken = user->kind == IR_UNARY && user->op == IR_OP_ADDRESS;
    const bool is_address = node->type->kind == IR_POINTER || node->type->kind == IR_ARRAY;
    if (is_taken)
        user = user->parent;
    return (is_taken || is_address) && user->kind != IR_CALL;
}
