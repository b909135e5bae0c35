/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A variable may replace an array element that the loop stores to (own.h) under these conditions:
 * - The element's subscript has a different value in each iteration, and nothing else in its
 *   address changes. Then no two iterations share an element, and its address may be computed at
 *   any time.
 * - Either each iteration reads the element before storing to it. Reading it at the beginning then
 *   does nothing that the program would not do. The element also has the read's type before the
 *   loop, and since the loop stores late, other iterations cannot read it as another type (C17
 *   6.5p7). Or each iteration stores to the element before reading it. Then nothing is read at the
 *   beginning, and types prove only that declared objects are disjoint (6.5p6).
 * - All other memory that the loop reads is disjoint from the element, by proof or by a comparison
 *   before anything is written. Everything else that the loop writes is an update, with which all
 *   reads are compared. So no iteration can observe that the store happens later.
 * - The loop's text names the element only by this expression, and never takes its address. */
#include "analysis/loop/own.h"

#include "analysis/base/expression.h"
#include "analysis/loop/type_changes.h"

enum { MOST_OWN = 16 };

/* ---- its form -------------------------------------------------------------------------------- */

/* Is the node the counter, possibly cast to a type at least as wide, plus or minus invariants? Its
 * values in different iterations then differ, even if sums wrap around. */
static bool differs_always(const loop_analysis *j, const ir_node *node) {
    if (node->kind == IR_CAST)
        return ir_type_is_plain_integer(node->type) &&
               node->type->size >= node->children[0]->type->size &&
               differs_always(j, node->children[0]);
    if (node->kind == IR_BINARY && (node->op == IR_OP_ADD || node->op == IR_OP_SUBTRACT)) {
        const ir_node *left = node->children[0], *right = node->children[1];
        return ir_type_is_plain_integer(left->type) && ir_type_is_plain_integer(right->type) &&
               ((differs_always(j, left) && analysis_is_fixed(j, right)) ||
                (analysis_is_fixed(j, left) && differs_always(j, right)));
    }
    return expression_is_variable(node, j->counted.counter);
}

static bool is_array(const loop_analysis *j, const ir_node *base) {
    return base->kind == IR_VARIABLE && base->variable->storage != IR_THREAD_LOCAL &&
           (base->type->kind == IR_ARRAY
                ? base->type->count > 0 && !ir_declarator_in(j->loop, base->variable)
                : base->type->kind == IR_POINTER && analysis_is_unchanged(j, base));
}

/* Is the node an element of an array (not of a pointer's target) with a constant subscript in
 * range, so that it certainly exists? */
static bool is_constant_inside(const ir_node *node) {
    int64_t value;
    return node->kind == IR_INDEX && node->children[0]->type->kind == IR_ARRAY &&
           expression_constant(node->children[1], &value) && value >= 0 &&
           value < node->children[0]->type->count;
}

/* The row t[i + c] that contains the lvalue; NULL if a bit-field is on the way. */
static const ir_node *row_of(const ir_node *lvalue) {
    const ir_node *node = lvalue;
    while ((node->kind == IR_MEMBER && !(node->flags & IR_ARROW)) || is_constant_inside(node)) {
        if (node->kind == IR_MEMBER && (!node->field || node->field->is_bit_field))
            return NULL;
        node = node->children[0];
    }
    return node;
}

bool own_is_element(const loop_analysis *j, const ir_node *lvalue) {
    const ir_node *node = row_of(lvalue);
    return node && j->counted.counter->type->kind == IR_INTEGER && node->kind == IR_INDEX &&
           is_array(j, node->children[0]) && differs_always(j, node->children[1]);
}

/* Can a value of the type be copied bit by bit and stored atomically? */
static bool has_type(const ir_type *type) {
    return type && type->spelling && !type->is_const && !type->is_volatile && !type->is_atomic &&
           (type->kind == IR_INTEGER || type->kind == IR_FLOATING) &&
           (type->size == 1 || type->size == 2 || type->size == 4 || type->size == 8);
}

/* ---- other accesses of the loop -------------------------------------------------------------- */

static bool is_of(const loop_access *a, const ir_node *element) {
    return !a->access.callee && a->access.is_exact && a->access.lvalue &&
           a->access.lvalue == a->access.node && expression_same(a->access.lvalue, element);
}

/* The access to the element that each iteration certainly makes first. */
typedef enum first_use { FIRST_UNKNOWN, FIRST_READ, FIRST_STORED } first_use;

static first_use first_use_of(const loop_analysis *j, const ir_node *element) {
    unsigned certain_read = UINT32_MAX, certain_store = UINT32_MAX;
    unsigned any_read = UINT32_MAX, any_store = UINT32_MAX;
    for (unsigned i = 0; i < j->access_count; i++) {
        const access *a = &j->accesses[i].access;
        if (!is_of(&j->accesses[i], element))
            continue;
        const bool reads =
            a->kind == ACCESS_READ || (a->kind == ACCESS_UPDATE && a->form.has_operator);
        /* a store happens after the assigned value has been evaluated */
        const unsigned at = reads ? a->node->id : expression_last_id(a->node->parent);
        unsigned *any = reads ? &any_read : &any_store;
        unsigned *certain = reads ? &certain_read : &certain_store;
        *any = at < *any ? at : *any;
        *certain = !a->is_conditional && at < *certain ? at : *certain;
    }
    return certain_read < UINT32_MAX && certain_read <= any_store   ? FIRST_READ
           : certain_store < UINT32_MAX && certain_store < any_read ? FIRST_STORED
                                                                    : FIRST_UNKNOWN;
}

/* Is each store to the element a separate statement? */
static bool stores_alone(const loop_analysis *j, const ir_node *element) {
    for (unsigned i = 0; i < j->access_count; i++) {
        const access *a = &j->accesses[i].access;
        if (a->kind == ACCESS_READ || !is_of(&j->accesses[i], element))
            continue;
        const ir_node *assignment = a->node->parent;
        const ir_node *statement = assignment ? assignment->parent : NULL;
        if (!statement || expression_written(assignment) != a->node ||
            statement->kind != IR_EXPRESSION || statement->range.begin >= statement->range.end)
            return false;
    }
    return true;
}

static bool takes_its_address(const ir_node *node, const ir_node *element) {
    if (node->kind == IR_UNARY && node->op == IR_OP_ADDRESS &&
        expression_same(node->children[0], element))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (takes_its_address(node->children[i], element))
            return true;
    return false;
}

/* The element's location, with the element's type as the type of the access. */
static location location_of_element(const loop_analysis *j, const ir_node *element) {
    location where = location_of(j->an->facts, element, j->loop);
    where.type = element->type;
    return where;
}

/* Does `other` access another scalar of the element's row, as x[t][0] and x[t][2] are of one row?
 * These are disjoint for any t. */
static bool is_other_part(const loop_analysis *j, const loop_access *other,
                          const ir_node *element) {
    const ir_node *lvalue = other->access.lvalue;
    return !other->access.callee && other->access.is_exact && lvalue == other->access.node &&
           lvalue->type && ir_type_is_scalar(lvalue->type) && own_is_element(j, lvalue) &&
           !expression_same(lvalue, element) && expression_same(row_of(lvalue), row_of(element));
}

/* Same as access_reads_first, but also for elements that own_take has not listed yet. */
static bool reads_first(const loop_analysis *j, const loop_access *other) {
    return own_is_element(j, other->access.lvalue) && is_of(other, other->access.lvalue)
               ? first_use_of(j, other->access.lvalue) == FIRST_READ
               : access_reads_first(j, other);
}

/* The overlap of the access `other` with the elements that `element` denotes in other
 * iterations. */
static overlap overlap_between(const loop_analysis *j, const loop_access *other,
                               const ir_node *element, const location *where, first_use first) {
    if (!other->access.lvalue)
        return other->access.kind == ACCESS_READ ? OVERLAP_MAYBE : OVERLAP_SAME;
    if (is_other_part(j, other, element))
        return OVERLAP_NO;
    return first == FIRST_READ && reads_first(j, other)
               ? locations_overlap(&j->an->rules, &other->where, where)
               : locations_overlap_store(&j->an->rules, &other->where, where);
}

static bool may_be_own(const loop_analysis *j, const ir_node *element, own_element *item) {
    const location where = location_of_element(j, element);
    const first_use first = first_use_of(j, element);
    *item = (own_element){.element = element, .is_stored_first = first == FIRST_STORED};
    if (!has_type(element->type) || where.is_inexact || where.is_punned || where.has_union ||
        where.has_bit_field || !where.base || first == FIRST_UNKNOWN || !stores_alone(j, element) ||
        takes_its_address(j->loop, element))
        return false;
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *other = &j->accesses[i];
        if (is_of(other, element))
            continue;
        const overlap found = overlap_between(j, other, element, &where, first);
        if (found == OVERLAP_SAME)
            return false;
        item->is_guarded |= found == OVERLAP_MAYBE &&
                            (other->access.kind == ACCESS_READ ||
                             (other->access.lvalue && own_is_element(j, other->access.lvalue)));
    }
    return true;
}

/* ---- all of the loop ------------------------------------------------------------------------- */

int own_named(const loop_analysis *j, const ir_node *node) {
    for (unsigned i = 0; i < j->own.count; i++)
        if (expression_same(node, j->own.items[i].element))
            return (int)i;
    return -1;
}

static void class_accesses(loop_analysis *j) {
    for (unsigned i = 0; i < j->access_count; i++) {
        loop_access *a = &j->accesses[i];
        for (unsigned k = 0; k < j->own.count; k++)
            if (is_of(a, j->own.items[k].element))
                a->class = a->access.kind == ACCESS_READ ? CLASS_FORWARDED : CLASS_SCALAR;
    }
}

static void add_first_reads(loop_analysis *j) {
    loop_access *all = ARENA_ARRAY(j->an->memory, loop_access, j->access_count + j->own.count + 1);
    for (unsigned i = 0; i < j->access_count; i++)
        all[i] = j->accesses[i];
    for (unsigned i = 0; i < j->own.count; i++) {
        const ir_node *element = j->own.items[i].element;
        all[j->access_count + i] = (loop_access){.access = {.kind = ACCESS_READ,
                                                            .lvalue = element,
                                                            .is_exact = true,
                                                            .type = element->type,
                                                            .node = element},
                                                 .where = location_of_element(j, element),
                                                 .is_scalar = j->own.items[i].is_guarded};
    }
    j->accesses = all;
    j->access_count += j->own.count;
}

void own_take(loop_analysis *j) {
    if (!j->an->keeps_own)
        return;
    for (unsigned i = 0; i < j->access_count && j->own.count < MOST_OWN; i++) {
        const access *a = &j->accesses[i].access;
        own_element item;
        if (a->kind == ACCESS_READ || a->callee || !a->lvalue || !own_is_element(j, a->lvalue) ||
            own_named(j, a->lvalue) >= 0 || !may_be_own(j, a->lvalue, &item))
            continue;
        VECTOR_PUSH(j->an->memory, &j->own, item);
    }
    if (j->own.count == 0)
        return;
    class_accesses(j);
    add_first_reads(j);
}

bool own_check(loop_analysis *j) {
    for (unsigned i = 0; i < j->own.count; i++) {
        const location where = location_of_element(j, j->own.items[i].element);
        for (unsigned k = 0; k < j->access_count; k++) {
            const loop_access *other = &j->accesses[k];
            if (other->access.kind == ACCESS_READ || other->class == CLASS_REDUCTION ||
                other->is_scalar ||
                (other->access.lvalue && own_named(j, other->access.lvalue) >= 0) ||
                (other->access.lvalue && is_other_part(j, other, j->own.items[i].element)))
                continue;
            if (!other->access.lvalue ||
                locations_overlap_store(&j->an->rules, &other->where, &where) != OVERLAP_NO)
                return analysis_refuse(j, REASON_OTHER_STORE, j->own.items[i].element,
                                       analysis_name(j, j->own.items[i].element));
        }
    }
    return true;
}
