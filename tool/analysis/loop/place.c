/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Decides which expressions the inspector may compute at another place, or under fewer conditions,
 * than the program does. */
#include "analysis/loop/place.h"

#include "analysis/base/expression.h"
#include "analysis/base/step_inside.h"
#include "analysis/loop/bases.h"

/* ---- under fewer conditions ----------------------------------------------------------------- */

bool slice_is_safe_anywhere(const ir_node *row) {
    return !expression_has_load(row, true) && !expression_has_hazard(row);
}

/* Does each iteration also make an equal load elsewhere, unconditionally? */
static bool is_made_anyway(const loop_analysis *j, const ir_node *load) {
    for (unsigned i = 0; i < j->access_count; i++) {
        const access *a = &j->accesses[i].access;
        if (a->kind == ACCESS_READ && !a->is_conditional && !a->callee && a->lvalue != load &&
            expression_same(a->lvalue, load))
            return true;
    }
    return false;
}

/* Do all variables in the expression keep one value throughout an iteration? Variables declared in
 * the loop do not, since they have no value before. */
static bool is_steady(const loop_analysis *j, const ir_node *node) {
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

bool slice_is_safe_here(const loop_analysis *j, const ir_node *node, bool as_address) {
    bool is_array = node->type && node->type->kind == IR_ARRAY;
    if (!as_address && !is_array && node->kind != IR_VARIABLE && expression_is_lvalue(node) &&
        expression_has_load(node, false))
        return is_steady(j, node) && (is_made_anyway(j, node) || base_is_in_object_read(j, node));
    if (expression_is_hazard(node))
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

const ir_node *slice_place(const loop_analysis *j, const ir_node *node) {
    const ir_node *place = expression_place(node);
    if (place && place->kind == IR_DECLARATOR && place->parent && place->parent->parent &&
        place->parent->parent->kind == IR_FOR)
        place = place->parent->parent;
    for (unsigned i = 0; place && i < j->updates.count; i++) /* an update counts as one
                                                              * statement */
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

/* Does `place` use the variable only in one step v++, which it executes at most once? Then the step
 * finds the value that the variable has at the beginning of `place`. A loop repeats its condition.
 */
static bool is_only_stepped(const loop_analysis *j, const ir_node *place,
                            const ir_variable *variable) {
    const variable_fact *fact = variable_fact_of(j->an->facts, variable);
    const ir_node *only = NULL;
    for (unsigned i = 0; i < fact->occurrences.count; i++) {
        const ir_node *use = fact->occurrences.items[i];
        if (ir_contains(place, use) && only)
            return false;
        if (ir_contains(place, use))
            only = use;
    }
    for (const ir_node *up = only; up && up != place; up = up->parent)
        if (ir_is_loop(up->parent) &&
            !(up->parent->kind == IR_FOR && up == up->parent->children[0]))
            return false;
    return only && only->parent && is_step_afterwards(only->parent);
}

static bool changes_in(const loop_analysis *j, const ir_node *row, const ir_node *place) {
    if (row->kind == IR_VARIABLE) {
        const ir_node *declarator = variable_fact_of(j->an->facts, row->variable)->declarator;
        if ((variable_written_in(j->an->facts, place, row->variable) &&
             !is_only_stepped(j, place, row->variable)) ||
            (declarator && ir_contains(place, declarator)))
            return true;
    }
    for (unsigned i = 0; i < row->child_count; i++)
        if (changes_in(j, row->children[i], place))
            return true;
    return false;
}

bool slice_loops_are_constant(unsigned count, const source_loop *loops) {
    int64_t constant;
    for (unsigned i = 0; i < count; i++)
        if (!expression_constant(loops[i].lower, &constant) ||
            !expression_constant(loops[i].bound, &constant))
            return false;
    return true;
}

bool slice_can_record(const loop_analysis *j, const loop_source *recorded, const ir_node *node,
                      const ir_node *place) {
    if (!place || (slice_is_ahead(node, place) &&
                   (!slice_is_safe_anywhere(recorded->row) ||
                    !slice_loops_are_constant(recorded->loop_count, recorded->loops))))
        return false;
    /* for an if or a switch, only the condition is computed before `place` */
    if (place->kind == IR_IF || place->kind == IR_SWITCH)
        place = place->children[0];
    for (unsigned i = 0; i < recorded->loop_count; i++)
        if (changes_in(j, recorded->loops[i].lower, place) ||
            changes_in(j, recorded->loops[i].bound, place))
            return false;
    return !changes_in(j, recorded->row, place);
}
