/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* After a store to an element, a read may use the stored value if
 * - it comes after the store in the store's block, so the store was executed before it in this
 *   iteration;
 * - it is the same expression as the store's target, and no operand changes in between;
 * - no other write between the store and the read can change the element. This must be proved: a
 *   guard, which compares reads with each array, would always fail for the array stored to;
 * - it is in the loop's text, so that a variable's name can replace it.
 *
 * If other expressions certainly read the element, the loop is refused. If they may read it, they
 * are guarded. */
#include "analysis/reduction/forward.h"

#include "analysis/base/expression.h"

static bool has_type(const ir_type *type) {
    return type && type->spelling && !type->is_volatile && !type->is_atomic &&
           (type->kind == IR_INTEGER || type->kind == IR_FLOATING || type->kind == IR_COMPLEX ||
            type->kind == IR_BOOLEAN);
}

/* Does the subscript consist of constants, and of local scalars that change only by name? */
static bool is_simple_subscript(const ir_node *node) {
    if (node->kind == IR_VARIABLE)
        return variable_is_automatic(node->variable) && !node->variable->address_taken &&
               ir_type_is_scalar(node->type) && !node->type->is_volatile;
    if (node->kind != IR_NUMBER && node->kind != IR_CAST && node->kind != IR_BINARY &&
        (node->kind != IR_UNARY || node->op == IR_OP_DEREFERENCE || node->op == IR_OP_ADDRESS))
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!is_simple_subscript(node->children[i]))
            return false;
    return expression_is_plain(node);
}

/* Is the node a variable, or an element such as o[t], s->o[t].x or o[t][c], in which only
 * subscripts can change? The analysis of each array checks that pointers in its base are
 * invariant. */
static bool is_simple_element(const ir_node *node) {
    switch (node->kind) {
    case IR_VARIABLE:
        return true;
    case IR_INDEX:
        return is_simple_subscript(node->children[1]) && is_simple_element(node->children[0]);
    case IR_MEMBER:
        return is_simple_element(node->children[0]);
    default:
        return false;
    }
}

/* Does the node, or a node below it, assign a subscript or pointer of the element? */
static bool changes_address(const loop_analysis *j, const ir_node *element, const ir_node *node) {
    if (element->kind == IR_VARIABLE && ir_type_is_scalar(element->type) &&
        variable_written_in(j->an->facts, node, element->variable))
        return true;
    for (unsigned i = 0; i < element->child_count; i++)
        if (changes_address(j, element->children[i], node))
            return true;
    return false;
}

/* Can a jump enter the statement other than at its beginning? */
static bool has_entry(const ir_node *node) {
    return ir_holds_case(node) || ir_has_kind(node, IR_LABEL);
}

static const ir_node *value_of(const loop_access *store) {
    const ir_node *assignment = store->access.lvalue->parent;
    return assignment && assignment->kind == IR_ASSIGN && assignment->op == IR_OP_NONE &&
                   assignment->children[0] == store->access.lvalue
               ? assignment->children[1]
               : NULL;
}

/* The store's statement. NULL if the store is no plain assignment to an element, or if a jump may
 * enter this or a later statement of its block. Also NULL if one of these statements, other than
 * the loop's own increment, changes the element's address. */
static const ir_node *statement_of(const loop_analysis *j, const loop_access *store) {
    const ir_node *target = store->access.lvalue;
    const ir_node *statement = value_of(store) ? target->parent->parent : NULL;
    if (store->access.callee || store->access.kind != ACCESS_WRITE || !statement ||
        statement->kind != IR_EXPRESSION || !has_type(target->type) ||
        target->kind == IR_VARIABLE || !is_simple_element(target))
        return NULL;
    const ir_node *block = statement->parent;
    if (!block || block->kind != IR_BLOCK || !ir_contains(j->counted.body, block))
        return NULL;
    for (unsigned i = 0; i < block->child_count; i++) {
        const ir_node *later = block->children[i];
        if (later->id >= statement->id && later != j->counted.increment &&
            !(j->counted.increment && !j->counted.steps_inside &&
              ir_contains(later, j->counted.increment)) &&
            (has_entry(later) || changes_address(j, target, later)))
            return NULL;
    }
    return statement;
}

/* The statement of the block that contains `node`; NULL if the node is not in the block. */
static const ir_node *statement_around(const ir_node *node, const ir_node *block) {
    while (node && node->parent != block)
        node = node->parent;
    return node;
}

static bool is_below(const ir_node *statement, const ir_node *node) {
    const ir_node *place = statement_around(node, statement->parent);
    return place && place->id > statement->id;
}

static bool may_use_value(const loop_access *read, const ir_node *statement,
                          const ir_node *target) {
    return read->access.kind == ACCESS_READ && !read->access.callee && read->access.lvalue &&
           read->access.lvalue == read->access.node && read->access.is_exact &&
           expression_same(read->access.lvalue, target) && is_below(statement, read->access.node);
}

/* Does the statement read everything before it writes, as h[o[t]] += o[t] does? */
static bool reads_before_it_writes(const ir_node *statement, const loop_access *write) {
    const ir_node *update = statement->kind == IR_EXPRESSION ? statement->children[0] : NULL;
    return update && (update->kind == IR_ASSIGN || ir_is_increment(update)) &&
           !write->access.callee && update->children[0] == write->access.node;
}

/* May the write happen between the store and a read that uses the stored value? */
static bool comes_between(const loop_analysis *j, const loop_access *write,
                          const ir_node *statement, const ir_node *target) {
    const ir_node *place = statement_around(write->access.node, statement->parent);
    if (!place || place->id < statement->id)
        return false; /* the write is before the store, or outside of its block */
    for (unsigned i = 0; i < j->access_count; i++) {
        const ir_node *read = j->accesses[i].access.node;
        if (!may_use_value(&j->accesses[i], statement, target))
            continue;
        const ir_node *reads = statement_around(read, statement->parent);
        if (place->id < reads->id || (place == reads && !reads_before_it_writes(place, write)))
            return true;
    }
    return false;
}

/* Returns false if another access certainly touches the element, or if another write may change it
 * between the store and a read that uses the stored value. Reads that use the stored value do not
 * count as other accesses. */
static bool is_alone(const loop_analysis *j, const loop_access *store, const ir_node *statement) {
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *other = &j->accesses[i];
        if (other == store || may_use_value(other, statement, store->access.lvalue))
            continue;
        const overlap meets = locations_overlap(&j->an->rules, &other->where, &store->where);
        if (meets == OVERLAP_SAME || (meets == OVERLAP_MAYBE && other->access.kind != ACCESS_READ &&
                                      comes_between(j, other, statement, store->access.lvalue)))
            return false;
    }
    return true;
}

/* Is every occurrence of the element in the loop a known read that may use the stored value? False
 * if the element's address is used. */
static bool is_read_everywhere(const loop_analysis *j, const ir_node *statement,
                               const ir_node *target, const ir_node *node) {
    if (node != target && expression_same(node, target)) {
        for (unsigned i = 0; i < j->access_count; i++)
            if (j->accesses[i].access.node == node &&
                may_use_value(&j->accesses[i], statement, target))
                return true;
        return false;
    }
    for (unsigned i = 0; i < node->child_count; i++)
        if (!is_read_everywhere(j, statement, target, node->children[i]))
            return false;
    return true;
}

bool forward_take(loop_analysis *j, const loop_access *store) {
    const ir_node *target = store->access.lvalue;
    const ir_node *statement = statement_of(j, store);
    if (!statement || !is_alone(j, store, statement) ||
        !is_read_everywhere(j, statement, target, j->loop))
        return false;
    for (unsigned i = 0; i < j->access_count; i++)
        if (may_use_value(&j->accesses[i], statement, target))
            j->accesses[i].class = CLASS_FORWARDED;
    const forwarded_store item = {statement, target, value_of(store)};
    VECTOR_PUSH(j->an->memory, &j->forwards, item);
    return true;
}

int forward_read(const loop_analysis *j, const ir_node *node) {
    for (unsigned i = 0; i < j->forwards.count; i++)
        if (node != j->forwards.items[i].target &&
            expression_same(node, j->forwards.items[i].target))
            return (int)i;
    return -1;
}
