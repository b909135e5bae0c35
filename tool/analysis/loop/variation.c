/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/loop/variation.h"

#include <assert.h>

#include "analysis/base/exact.h"
#include "analysis/base/expression.h"

/* Is the variable a counter of a called function? Accesses that the callee makes may mention it
 * (access.loops). */
static bool is_of_callee(variable_facts *facts, const ir_node *loop, const ir_variable *variable) {
    const ir_node *outer = variable_fact_of(facts, variable)->declarator;
    while (loop->parent)
        loop = loop->parent;
    while (outer && outer->parent)
        outer = outer->parent;
    return variable->storage == IR_LOCAL && outer && outer != loop;
}

bool variation_is_invariant(variable_facts *facts, const ir_node *loop, const ir_node *expression) {
    assert(ir_is_expression(expression));
    if (expression->kind == IR_CALL || expression->kind == IR_OPAQUE ||
        expression->kind == IR_ASSIGN || expression_written(expression))
        return false;
    if (expression->kind == IR_VARIABLE)
        return !is_of_callee(facts, loop, expression->variable) &&
               !variable_may_change_in(facts, loop, expression->variable) &&
               !(expression->variable->function &&
                 ir_contains(loop, variable_fact_of(facts, expression->variable)->declarator));
    for (unsigned i = 0; i < expression->child_count; i++)
        if (!variation_is_invariant(facts, loop, expression->children[i]))
            return false;
    return true;
}

bool variation_is_fixed(variable_facts *facts, const ir_node *loop, const ir_node *lvalue) {
    const ir_node *child = lvalue->child_count ? lvalue->children[0] : NULL;
    switch (lvalue->kind) {
    case IR_VARIABLE: {
        const ir_node *declarator = variable_fact_of(facts, lvalue->variable)->declarator;
        return !declarator || !ir_contains(loop, declarator);
    }
    case IR_INDEX:
        return variation_is_invariant(facts, loop, lvalue->children[1]) &&
               (ir_is_array(child) ? variation_is_fixed(facts, loop, child)
                                   : variation_is_invariant(facts, loop, child));
    case IR_MEMBER:
        return (lvalue->flags & IR_ARROW) && !ir_is_array(child)
                   ? variation_is_invariant(facts, loop, child)
                   : variation_is_fixed(facts, loop, child);
    case IR_UNARY:
        if (lvalue->op == IR_OP_DEREFERENCE)
            return ir_is_array(child) ? variation_is_fixed(facts, loop, child)
                                      : variation_is_invariant(facts, loop, child);
        return false;
    default:
        return false;
    }
}

/* ---- affine in one counter ------------------------------------------------------------------ */

static affine_form affine_of_binary(const ir_node *node, affine_form a, affine_form b) {
    affine_form none = {0};
    if (!a.is_affine || !b.is_affine)
        return none;
    bool a_invariant = a.is_known && a.multiple == 0;
    bool b_invariant = b.is_known && b.multiple == 0;
    affine_form sum = {true, a.is_known && b.is_known, 0};
    int64_t constant;
    switch (node->op) {
    case IR_OP_ADD:
        sum.multiple = a.multiple + b.multiple;
        return sum;
    case IR_OP_SUBTRACT:
        sum.multiple = a.multiple - b.multiple;
        return sum;
    default: /* multiplication */
        if (a_invariant && b_invariant)
            return sum;
        if (!(expression_constant(node->children[1], &constant) && a.is_known &&
              !__builtin_mul_overflow(a.multiple, constant, &sum.multiple)) &&
            !(expression_constant(node->children[0], &constant) && b.is_known &&
              !__builtin_mul_overflow(b.multiple, constant, &sum.multiple)))
            sum.is_known = false;
        return a_invariant || b_invariant ? sum : none;
    }
}

affine_form variation_affine(variable_facts *facts, const ir_node *loop, const ir_variable *counter,
                             const ir_node *expression) {
    assert(counter && ir_is_expression(expression));
    affine_form none = {0};
    if (expression->kind == IR_VARIABLE && expression->variable == counter)
        return (affine_form){true, true, 1};
    if (variation_is_invariant(facts, loop, expression) &&
        !expression_mentions(expression, counter))
        return (affine_form){true, true, 0};
    if (!exact_is_operation(expression))
        return none;
    affine_form result = variation_affine(facts, loop, counter, expression->children[0]);
    if (expression->kind == IR_BINARY)
        result = affine_of_binary(expression, result,
                                  variation_affine(facts, loop, counter, expression->children[1]));
    else if (expression->kind == IR_UNARY && expression->op == IR_OP_MINUS)
        result.multiple = -result.multiple;
    if (result.is_known && (result.multiple > INT32_MAX || result.multiple < -INT32_MAX))
        return none;
    return result;
}

/* ---- irregular ------------------------------------------------------------------------------ */

enum { DEEPEST = 8 }; /* greatest number of definitions that are followed */

typedef struct regularity {
    variable_facts *facts;
    const ir_node *loop;
    unsigned depth;
} regularity;

static bool is_varying(regularity *r, const ir_node *node);

/* Is the write a step, v++ or v += c with an invariant c? */
static bool is_step(const regularity *r, const ir_node *write) {
    if (write->kind == IR_UNARY)
        return write->op != IR_OP_ADDRESS;
    return write->kind == IR_ASSIGN && (write->op == IR_OP_ADD || write->op == IR_OP_SUBTRACT) &&
           variation_is_invariant(r->facts, r->loop, write->children[1]);
}

static bool is_in_for_header(const ir_node *write) {
    const ir_node *place = write;
    while (place->parent && place->parent->kind != IR_FOR && place->parent->kind != IR_BLOCK)
        place = place->parent;
    return place->parent && place->parent->kind == IR_FOR && place->parent->children[1] != place &&
           place->parent->children[3] != place;
}

/* Is the variable a counter? The loop must only step it, or set it in the header of a for. What the
 * condition sets, as in for (...; (k = list[i]) >= 0; ...), is no counter. */
static bool is_counter(const regularity *r, const ir_variable *variable) {
    const variable_fact *fact = variable_fact_of(r->facts, variable);
    for (unsigned i = 0; i < fact->writes.count; i++) {
        const ir_node *write = fact->writes.items[i];
        if (ir_contains(r->loop, write) && !is_step(r, write) && !is_in_for_header(write))
            return false;
    }
    return true;
}

static bool is_irregular_place(regularity *r, const ir_node *lvalue);

/* The value that a write in a for's header gives a counter; NULL if the write is a step. */
static const ir_node *first_value(const ir_node *write) {
    if (write->kind == IR_DECLARATOR)
        return write->child_count ? write->children[0] : NULL;
    return write->kind == IR_ASSIGN && write->op == IR_OP_NONE ? write->children[1] : NULL;
}

/* Does the value come from an element that is itself found through a table, as in start[row[t]]?
 * False for start[t], the beginning of the t-th of consecutive segments. */
static bool is_looked_up(regularity *r, const ir_node *value) {
    if ((value->kind == IR_INDEX || value->kind == IR_MEMBER || value->kind == IR_UNARY) &&
        is_irregular_place(r, value))
        return true;
    if (value->kind == IR_VARIABLE) {
        const ir_node *definition = variable_single_definition(r->facts, value->variable);
        if (!definition || r->depth >= DEEPEST || !ir_contains(r->loop, definition))
            return false;
        r->depth++;
        const bool result = is_looked_up(r, definition);
        r->depth--;
        return result;
    }
    for (unsigned i = 0; i < value->child_count; i++)
        if (is_looked_up(r, value->children[i]))
            return true;
    return false;
}

/* Does the counter begin at a value found through a table, as in for (k = start[row[t]]; ...)? */
static bool begins_irregularly(regularity *r, const ir_variable *counter) {
    const variable_fact *fact = variable_fact_of(r->facts, counter);
    bool result = false;
    r->depth++;
    for (unsigned i = 0; i < fact->writes.count && r->depth <= DEEPEST && !result; i++) {
        const ir_node *value = first_value(fact->writes.items[i]);
        result = value && ir_contains(r->loop, value) && is_looked_up(r, value);
    }
    r->depth--;
    return result;
}

static bool is_irregular_value(regularity *r, const ir_node *node) {
    if (!is_varying(r, node))
        return false;
    switch (node->kind) {
    case IR_VARIABLE: {
        if (is_counter(r, node->variable))
            return begins_irregularly(r, node->variable);
        const ir_node *value = variable_single_definition(r->facts, node->variable);
        if (!value || r->depth >= DEEPEST || !ir_contains(r->loop, value))
            return true;
        r->depth++;
        bool result = is_irregular_value(r, value);
        r->depth--;
        return result;
    }
    case IR_BINARY:
        if (node->op == IR_OP_ADD || node->op == IR_OP_SUBTRACT)
            return is_irregular_value(r, node->children[0]) ||
                   is_irregular_value(r, node->children[1]);
        if (node->op == IR_OP_MULTIPLY)
            return is_irregular_value(r, node->children[0]) ||
                   is_irregular_value(r, node->children[1]) ||
                   (is_varying(r, node->children[0]) && is_varying(r, node->children[1]));
        return true;
    case IR_CAST:
        return is_irregular_value(r, node->children[0]);
    case IR_UNARY:
        if (node->op == IR_OP_MINUS || node->op == IR_OP_PLUS)
            return is_irregular_value(r, node->children[0]);
        if (node->op == IR_OP_ADDRESS)
            return is_irregular_place(r, node->children[0]);
        if (node->op >= IR_OP_PRE_INCREMENT)
            return is_irregular_value(r, node->children[0]);
        return true;
    default:
        return true;
    }
}

static bool is_varying(regularity *r, const ir_node *node) {
    return !variation_is_invariant(r->facts, r->loop, node);
}

static bool is_irregular_place(regularity *r, const ir_node *lvalue) {
    const ir_node *node = lvalue;
    bool has_subscript = false;
    unsigned hops = 0;
    while (node && hops++ < 64) {
        switch (node->kind) {
        case IR_INDEX:
            has_subscript = true;
            if (is_irregular_value(r, node->children[1]))
                return true;
            node = node->children[0];
            break;
        case IR_MEMBER:
        case IR_CAST:
            node = node->children[0];
            break;
        case IR_UNARY:
            if (node->op != IR_OP_DEREFERENCE && node->op != IR_OP_ADDRESS)
                return false;
            node = node->children[0];
            break;
        case IR_BINARY: /* *(p + k) */
            if (is_irregular_value(r, node->children[1]) ||
                (node->children[1]->type && node->children[1]->type->kind == IR_POINTER &&
                 is_irregular_value(r, node->children[0])))
                return true;
            node = node->children[node->children[1]->type &&
                                          node->children[1]->type->kind == IR_POINTER
                                      ? 1
                                      : 0];
            has_subscript = true;
            break;
        case IR_VARIABLE: {
            if (!is_varying(r, node))
                return false;
            const ir_node *value = variable_single_definition(r->facts, node->variable);
            if (value && ir_contains(r->loop, value) && node->variable->type->kind == IR_POINTER) {
                node = value;
                break;
            }
            return has_subscript && node->variable->type->kind == IR_POINTER &&
                   !is_counter(r, node->variable);
        }
        case IR_CALL:
            return true;
        default:
            return false;
        }
    }
    return false;
}

bool variation_is_irregular(variable_facts *facts, const ir_node *loop, const ir_node *lvalue) {
    regularity r = {facts, loop, 0};
    return is_irregular_place(&r, lvalue);
}
