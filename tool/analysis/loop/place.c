/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* What the inspector may compute at another place, or under fewer conditions, than the program. */
#include "analysis/loop/place.h"

#include "analysis/base/expression.h"

/* ---- under fewer conditions ----------------------------------------------------------------- */

static bool is_floating(const ir_type *type) {
    return type && (type->kind == IR_FLOATING || type->kind == IR_COMPLEX);
}

static bool is_scalar_access(const ir_node *node) {
    return expression_is_lvalue(node) || node->kind == IR_NUMBER;
}

/* Does a floating value come in here that is computed, compared or converted? It may be out of
 * range, or not a number, and exceptions may stop the program. */
static bool has_floating_hazard(const ir_node *node) {
    if (is_floating(node->type) && !is_scalar_access(node))
        return true;
    if (node->kind == IR_DECLARATOR && node->child_count && node->children[0]->type &&
        is_floating(node->children[0]->type))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (is_floating(node->children[i]->type) &&
            (node->kind == IR_CAST || node->kind == IR_BINARY || node->kind == IR_ASSIGN ||
             node->kind == IR_INITIALIZERS))
            return true;
    return false;
}

/* A divisor that is neither 0 nor -1, a number of places within the type. */
static bool is_harmless_operand(const ir_node *node, const ir_node *right) {
    int64_t constant;
    if (!expression_constant(right, &constant))
        return false;
    if (node->op == IR_OP_DIVIDE || node->op == IR_OP_REMAINDER)
        return constant != 0 && constant != -1;
    return constant >= 0 && node->type && constant < node->type->size * 8;
}

/* May it have no meaning, for some operands? Sums and products of signed integers do too: they are
 * written so that they wrap around (emit/unconditional.c), but for those that assign. */
static bool is_hazard(const ir_node *node) {
    const bool assigns = node->kind == IR_ASSIGN && node->op != IR_OP_NONE;
    const bool counts = node->kind == IR_UNARY && node->op >= IR_OP_PRE_INCREMENT &&
                        node->op <= IR_OP_POST_DECREMENT;
    if (node->kind == IR_CALL || node->kind == IR_OPAQUE || assigns || counts ||
        has_floating_hazard(node))
        return true;
    if (node->kind != IR_BINARY)
        return false;
    if (node->op == IR_OP_DIVIDE || node->op == IR_OP_REMAINDER || node->op == IR_OP_SHIFT_LEFT ||
        node->op == IR_OP_SHIFT_RIGHT)
        return !is_harmless_operand(node, node->children[1]);
    return node->op == IR_OP_SUBTRACT && node->children[1]->type &&
           node->children[1]->type->kind == IR_POINTER; /* of different objects, perhaps */
}

static bool has_hazard(const ir_node *node) {
    if (is_hazard(node))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (has_hazard(node->children[i]))
            return true;
    return false;
}

bool slice_is_safe_anywhere(const ir_node *row) {
    return !expression_has_load(row, true) && !has_hazard(row);
}

/* Is this load made in each iteration whatever the conditions, with the same address? */
static bool is_made_anyway(const judgement *j, const ir_node *load) {
    for (unsigned i = 0; i < j->access_count; i++) {
        const access *a = &j->accesses[i].access;
        if (a->kind == ACCESS_READ && !a->is_conditional && !a->callee && a->lvalue != load &&
            expression_same(a->lvalue, load))
            return true;
    }
    return false;
}

/* Nothing in it changes in the course of an iteration. */
static bool is_steady(const judgement *j, const ir_node *node) {
    if (node->kind == IR_VARIABLE && node->variable != j->counted.counter &&
        variable_written_in(j->an->facts, j->loop, node->variable))
        return false;
    if (node->kind == IR_VARIABLE) {
        const ir_node *declarator = variable_fact_of(j->an->facts, node->variable)->declarator;
        return node->variable == j->counted.counter || !declarator ||
               !ir_contains(j->loop, declarator);
    }
    for (unsigned i = 0; i < node->child_count; i++)
        if (!is_steady(j, node->children[i]))
            return false;
    return true;
}

bool slice_is_safe_here(const judgement *j, const ir_node *node, bool as_address) {
    bool is_array = node->type && node->type->kind == IR_ARRAY;
    if (!as_address && !is_array && node->kind != IR_VARIABLE && expression_is_lvalue(node) &&
        expression_has_load(node, false))
        return is_steady(j, node) && is_made_anyway(j, node);
    if (is_hazard(node))
        return false;
    for (unsigned i = 0; i < node->child_count; i++) {
        const ir_node *child = node->children[i];
        bool child_as_address = (child->type && child->type->kind == IR_ARRAY) ||
                                (node->kind == IR_MEMBER && !(node->flags & IR_ARROW)) ||
                                (node->kind == IR_UNARY && node->op == IR_OP_ADDRESS);
        if (!slice_is_safe_here(j, child, child_as_address))
            return false;
    }
    return true;
}

/* ---- places --------------------------------------------------------------------------------- */

const ir_node *slice_place(const judgement *j, const ir_node *node) {
    const ir_node *place = expression_place(node);
    if (place && place->kind == IR_DECLARATOR && place->parent && place->parent->parent &&
        place->parent->parent->kind == IR_FOR)
        place = place->parent->parent;
    for (unsigned i = 0; place && i < j->updates.count; i++) /* an update is one statement */
        if (ir_contains(j->updates.items[i].statement, place))
            place = j->updates.items[i].statement;
    return place && place != j->loop && ir_contains(j->loop, place) ? place : NULL;
}

bool slice_is_ahead(const ir_node *node, const ir_node *place) {
    for (const ir_node *up = node; up != place && up->parent; up = up->parent) {
        const ir_node *parent = up->parent;
        if ((parent->kind == IR_CONDITIONAL || parent->kind == IR_IF) && parent->children[0] != up)
            return true;
        if (parent->kind == IR_BINARY && (parent->op == IR_OP_AND || parent->op == IR_OP_OR) &&
            parent->children[1] == up)
            return true;
    }
    return false;
}

static bool changes_in(const judgement *j, const ir_node *row, const ir_node *place) {
    if (row->kind == IR_VARIABLE) {
        const ir_node *declarator = variable_fact_of(j->an->facts, row->variable)->declarator;
        if (variable_written_in(j->an->facts, place, row->variable) ||
            (declarator && ir_contains(place, declarator)))
            return true;
    }
    for (unsigned i = 0; i < row->child_count; i++)
        if (changes_in(j, row->children[i], place))
            return true;
    return false;
}

bool slice_can_tell(const judgement *j, const ir_node *row, const ir_node *node,
                    const ir_node *place) {
    if (!place || (slice_is_ahead(node, place) && !slice_is_safe_anywhere(row)))
        return false;
    /* Of if and switch only the condition is computed between. */
    if (place->kind == IR_IF || place->kind == IR_SWITCH)
        place = place->children[0];
    return !changes_in(j, row, place);
}
