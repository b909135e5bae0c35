/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/memory/callee_values.h"

#include <assert.h>

#include "analysis/base/expression.h"
#include "analysis/memory/alias.h"
#include "analysis/memory/last_change.h"
#include "ir/ir_words.h"

enum {
    MOST_DEPTH = 8,
    MOST_NODES = 200
}; /* greatest depth of nested replacements of variables by values, and greatest number of nodes in
    * a result */

static ir_node *unknown_part(callee_rewriting *r, const ir_node *node) {
    ir_node *unknown = ir_new(r->terms->memory, IR_OPAQUE, node->type, 0);
    unknown->text = "?";
    unknown->range = node->range;
    r->is_exact = false;
    return unknown;
}

/* ---- loads ----------------------------------------------------------------------------------- */

/* Is the load's value constant while the function runs, because the function itself does not write
 * memory that the load reads? */
static bool is_stable(const callee_rewriting *r, const ir_node *load) {
    for (unsigned i = 0; i < r->terms->raw->items.count; i++) {
        const access *store = &r->terms->raw->items.items[i];
        if (store->kind == ACCESS_READ || (store->lvalue && store->lvalue->kind == IR_VARIABLE &&
                                           variable_is_automatic(store->lvalue->variable)))
            continue;
        if (!r->terms->strict_aliasing || types_may_overlap(store->type, load->type))
            return false;
    }
    return true;
}

/* Does the node belong to the text of this function, and not to another function's access? */
static bool is_of_text(const callee_rewriting *r, const ir_node *node) {
    return r->loops && ir_contains(r->loops->body, node);
}

/* Does the expression have the same value at both nodes? Each local variable in it must be an
 * unchanged parameter, or the counter of a loop around both. */
static bool has_one_value(const callee_rewriting *r, const ir_node *node, const ir_node *first,
                          const ir_node *second) {
    if (node->kind == IR_VARIABLE && variable_is_automatic(node->variable)) {
        const variable_fact *fact = variable_fact_of(r->terms->facts, node->variable);
        const bool is_fixed = node->variable->storage == IR_PARAMETER && !fact->write_count &&
                              !node->variable->address_taken;
        return is_fixed || callee_loops_share(r->loops, node->variable, first, second);
    }
    for (unsigned i = 0; i < node->child_count; i++)
        if (!has_one_value(r, node->children[i], first, second))
            return false;
    return true;
}

static bool is_member_of(const ir_node *lvalue, const ir_node *pointer) {
    return lvalue->kind == IR_MEMBER && lvalue->flags & IR_ARROW &&
           expression_same(lvalue->children[0], pointer);
}

/* Is memory at the load's address certain to be read, by this load or an equal one? A certain read
 * of another member of the same object suffices, because it shows that the pointer is valid. */
static bool is_certain_load(const callee_rewriting *r, const ir_node *load) {
    if (callee_loops_is_certain(r->loops, load))
        return true;
    const ir_node *pointer =
        load->kind == IR_MEMBER && load->flags & IR_ARROW ? load->children[0] : NULL;
    for (unsigned i = 0; i < r->terms->raw->items.count; i++) {
        const access *other = &r->terms->raw->items.items[i];
        const bool is_alike = other->kind == ACCESS_READ && !other->callee && other->lvalue &&
                              (expression_same(other->lvalue, load) ||
                               (pointer && is_member_of(other->lvalue, pointer)));
        if (is_alike && callee_loops_is_certain(r->loops, other->node) &&
            has_one_value(r, pointer ? pointer : load, load, other->node))
            return true;
    }
    return false;
}

static void note_load(callee_rewriting *r, const ir_node *load) {
    r->has_load = true;
    if (!r->loads_stay && !is_stable(r, load))
        r->is_exact = false;
    if (!r->loops)
        return;
    if (is_of_text(r, load))
        r->loads_are_certain &= is_certain_load(r, load);
    else /* The load is in a function that this function calls. It is certain if the call is
          * certain, and the load is in loops recorded for the access or is unconditional in the
          * called function. */
        r->loads_are_certain &= callee_loops_is_certain(r->loops, r->item->node) &&
                                (r->item->loop_count || !r->item->is_conditional);
}

ir_node *callee_rewrite_value(callee_rewriting *r, const ir_node *node) {
    if (expression_is_scalar_access(node))
        note_load(r, node);
    return callee_rewrite(r, node);
}

/* The value converted to the type, as an assignment to a variable would convert it. */
static ir_node *as_type(arena *a, ir_node *value, const ir_type *type) {
    if (!value->type || ir_type_equal(value->type, type) || !ir_type_is_scalar(type) ||
        type->kind == IR_POINTER)
        return value;
    ir_node *cast = ir_new(a, IR_CAST, type, 1);
    cast->range = value->range;
    cast->children[0] = value;
    value->parent = cast;
    return cast;
}

/* ---- variables set several times ------------------------------------------------------------- */

static ir_node *value_before(callee_rewriting *r, const ir_node *node, const ir_node *site);

/* value <op> operand, with the type that C gives the result. */
static ir_node *operation(callee_rewriting *r, ir_operator op, ir_node *value, ir_node *operand) {
    arena *a = r->terms->memory;
    ir_node *result = ir_new(a, IR_BINARY, NULL, 2);
    result->op = op;
    result->range = operand->range;
    result->children[0] = value;
    result->children[1] = operand;
    value->parent = operand->parent = result;
    const ir_type *type = ir_infer_type(a, result);
    for (unsigned i = 0; type && i < 2 && !result->type; i++)
        if (ir_type_equal(result->children[i]->type, type))
            result->type = result->children[i]->type; /* reused because it has the type's other
                                                       * properties, such as wraps */
    if (!result->type)
        result = unknown_part(r, value);
    return result;
}

static ir_node *one(callee_rewriting *r, const ir_node *change) {
    ir_type *type = ARENA_NEW(r->terms->memory, ir_type);
    ir_scalar_type(type, ir_scalar_named("int", 3));
    ir_node *number = ir_new(r->terms->memory, IR_NUMBER, type, 0);
    number->text = "1";
    number->value = 1;
    number->flags = IR_FROM_MACRO | IR_HAS_VALUE;
    number->range = change->range;
    return number;
}

/* The value that a declarator, an assignment or an increment gives the variable. */
static ir_node *value_given(callee_rewriting *r, const ir_node *node, const ir_node *change) {
    assert(change->kind == IR_ASSIGN || change->kind == IR_DECLARATOR || ir_is_increment(change));
    const ir_node *site = r->site;
    ir_node *value;
    r->site = change;
    if (ir_is_increment(change)) {
        const bool is_up = change->op == IR_OP_PRE_INCREMENT || change->op == IR_OP_POST_INCREMENT;
        value = operation(r, is_up ? IR_OP_ADD : IR_OP_SUBTRACT, value_before(r, node, change),
                          one(r, change));
    } else {
        value = callee_rewrite_value(r, change->children[change->child_count - 1]);
        if (change->kind == IR_ASSIGN && change->op != IR_OP_NONE)
            value = operation(r, change->op, value_before(r, node, change), value);
    }
    r->site = site;
    return as_type(r->terms->memory, value, node->variable->type);
}

static ir_node *value_after(callee_rewriting *r, const ir_node *node, last_change change);

/* The variable's value after an `if` that may change it: condition ? value : value. */
static ir_node *value_of_branches(callee_rewriting *r, const ir_node *node,
                                  const ir_node *branches) {
    assert(node->kind == IR_VARIABLE && branches->kind == IR_IF);
    ir_node *choice = ir_new(r->terms->memory, IR_CONDITIONAL, node->variable->type, 3);
    const ir_node *site = r->site;
    r->site = branches;
    choice->range = branches->children[0]->range;
    choice->children[0] = callee_rewrite_value(r, branches->children[0]);
    for (unsigned i = 1; i < 3; i++) {
        last_change change = {CHANGE_NONE, NULL};
        if (i < branches->child_count)
            change = last_change_in(r->terms->facts, node->variable, branches->children[i]);
        choice->children[i] = change.kind == CHANGE_NONE ? value_before(r, node, branches)
                                                         : value_after(r, node, change);
    }
    for (unsigned i = 0; i < 3; i++)
        choice->children[i]->parent = choice;
    r->site = site;
    return choice;
}

static ir_node *value_after(callee_rewriting *r, const ir_node *node, last_change change) {
    if (change.kind == CHANGE_UNKNOWN || r->depth > MOST_DEPTH)
        return unknown_part(r, node);
    r->depth++;
    ir_node *value = change.kind == CHANGE_SET ? value_given(r, node, change.node)
                                               : value_of_branches(r, node, change.node);
    r->depth--;
    return value;
}

/* The value at `site` of the variable that `node` names. */
static ir_node *value_before(callee_rewriting *r, const ir_node *node, const ir_node *site) {
    const ir_variable *variable = node->variable;
    const ir_type *type = variable->type;
    if (!r->follows_changes || !site || variable->address_taken || type->is_volatile ||
        type->is_atomic || !ir_type_is_scalar(type) || type->kind == IR_POINTER)
        return unknown_part(r, node);
    const last_change change =
        last_change_before(r->terms->facts, r->terms->function, variable, site);
    if (change.kind == CHANGE_NONE)
        return variable->storage == IR_PARAMETER ? ir_substitute(r->terms->memory, node, NULL, NULL)
                                                 : unknown_part(r, node);
    return value_after(r, node, change);
}

/* ---- variables ------------------------------------------------------------------------------- */

static ir_node *rewrite_definition(callee_rewriting *r, const ir_node *node) {
    const ir_variable *variable = node->variable;
    const ir_node *value = variable_single_definition(r->terms->facts, variable);
    if (!value && variable_fact_of(r->terms->facts, variable)->write_count > 1)
        return value_before(r, node, r->site);
    if (!value || r->depth > MOST_DEPTH || value->kind == IR_INITIALIZERS ||
        variable->type->kind == IR_ARRAY || !expression_is_plain(value))
        return unknown_part(r, node);
    const ir_node *site = r->site;
    const ir_node *place = variable_fact_of(r->terms->facts, variable)->definition_place;
    r->site = site && callee_loops_is_set_before(place, site) ? value : NULL;
    r->depth++;
    ir_node *result = as_type(r->terms->memory, callee_rewrite_value(r, value), variable->type);
    r->depth--;
    r->site = site;
    return result;
}

static bool is_counter_of_callee(const callee_rewriting *r, const ir_variable *variable) {
    for (unsigned i = 0; r->loops && i < r->item->loop_count; i++)
        if (r->item->loops[i].counter == variable)
            return true;
    return false;
}

static ir_node *rewrite_variable(callee_rewriting *r, const ir_node *node) {
    const ir_variable *variable = node->variable;
    if (is_counter_of_callee(r, variable) ||
        (r->loops && callee_loops_counter(r->loops, variable, r->site)))
        return ir_substitute(r->terms->memory, node, NULL, NULL);
    if (variable->storage == IR_PARAMETER) {
        if (variable_fact_of(r->terms->facts, variable)->write_count || variable->address_taken ||
            variable->type->kind == IR_RECORD)
            return value_before(r, node, r->site);
        return ir_substitute(r->terms->memory, node, NULL, NULL);
    }
    if (variable->storage == IR_LOCAL)
        return rewrite_definition(r, node);
    if (variable->storage == IR_STATIC_LOCAL || variable->is_unnamed ||
        hidden_names_has(r->terms->names, variable))
        r->is_exact = false;
    return ir_substitute(r->terms->memory, node, NULL, NULL);
}

ir_node *callee_rewrite(callee_rewriting *r, const ir_node *node) {
    if (node->kind == IR_VARIABLE)
        return rewrite_variable(r, node);
    const bool is_unspelled = node->kind == IR_CAST && node->type && !node->type->spelling;
    if (node->kind == IR_OPAQUE || node->kind == IR_CALL || node->kind == IR_ASSIGN ||
        is_unspelled || (r->follows_changes && r->nodes++ > MOST_NODES))
        return unknown_part(r, node);
    ir_node *copy = ir_new(r->terms->memory, node->kind, node->type, node->child_count);
    ir_node **children = copy->children;
    *copy = *node;
    copy->children = children;
    copy->parent = NULL;
    for (unsigned i = 0; i < node->child_count; i++) {
        const ir_node *child = node->children[i];
        const bool is_address = (node->kind == IR_MEMBER && !(node->flags & IR_ARROW)) ||
                                (node->kind == IR_UNARY && node->op == IR_OP_ADDRESS);
        children[i] = is_address ? callee_rewrite(r, child) : callee_rewrite_value(r, child);
        children[i]->parent = copy;
    }
    return copy;
}
