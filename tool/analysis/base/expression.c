/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/expression.h"

#include <assert.h>
#include <string.h>

#include "ir/ir_c.h"

bool expression_constant(const ir_node *node, int64_t *value) {
    if (!node || !(node->flags & IR_HAS_VALUE))
        return false;
    *value = node->value;
    return true;
}

/* The pointer p of *p or p[0]; NULL for other expressions. */
static const ir_node *first_element(const ir_node *node) {
    int64_t subscript;
    if (node->kind == IR_UNARY && node->op == IR_OP_DEREFERENCE)
        return node->children[0];
    return node->kind == IR_INDEX && expression_constant(node->children[1], &subscript) &&
                   subscript == 0
               ? node->children[0]
               : NULL;
}

bool expression_same(const ir_node *a, const ir_node *b) {
    if (a == b)
        return true;
    if (!a || !b)
        return false;
    const ir_node *pointer = first_element(a), *other = first_element(b);
    if (pointer && other)
        return expression_same(pointer, other);
    int64_t x, y;
    if (expression_constant(a, &x) && expression_constant(b, &y))
        return x == y && a->type && b->type && ir_type_equal(a->type, b->type);
    if (a->kind != b->kind || a->op != b->op || a->child_count != b->child_count ||
        a->variable != b->variable || a->function != b->function || a->field != b->field ||
        ((a->flags ^ b->flags) & IR_ARROW) || a->kind == IR_OPAQUE)
        return false;
    if (a->kind == IR_SIZEOF) /* a sizeof without a value; elsewhere its text may denote another
                               * type */
        return false;
    if ((a->kind == IR_NUMBER || a->kind == IR_STRING) && !source_same_text(a->text, b->text))
        return false;
    if (a->kind == IR_CAST && !ir_type_equal(a->type, b->type))
        return false;
    for (unsigned i = 0; i < a->child_count; i++)
        if (!expression_same(a->children[i], b->children[i]))
            return false;
    return true;
}

unsigned expression_occurrences(const ir_node *node, const ir_node *part) {
    assert(part);
    if (expression_same(node, part))
        return 1;
    unsigned count = 0;
    for (unsigned i = 0; i < node->child_count; i++)
        count += expression_occurrences(node->children[i], part);
    return count;
}

bool expression_mentions(const ir_node *node, const ir_variable *variable) {
    if (!node)
        return false;
    if (node->kind == IR_VARIABLE && node->variable == variable)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (expression_mentions(node->children[i], variable))
            return true;
    return false;
}

bool expression_is_plain(const ir_node *node) {
    return !ir_has_effect(node);
}

bool expression_has_load(const ir_node *node, bool as_address) {
    switch (node->kind) {
    case IR_VARIABLE:
        return false;
    case IR_INDEX:
        if (!as_address && !ir_is_array(node))
            return true;
        return expression_has_load(node->children[0], ir_is_array(node->children[0])) ||
               expression_has_load(node->children[1], false);
    case IR_MEMBER:
        if (node->flags & IR_ARROW) {
            if (!as_address && !ir_is_array(node))
                return true;
            return expression_has_load(node->children[0], ir_is_array(node->children[0]));
        }
        return expression_has_load(node->children[0], as_address || ir_is_array(node));
    case IR_UNARY:
        if (node->op == IR_OP_ADDRESS)
            return expression_has_load(node->children[0], true);
        if (node->op == IR_OP_DEREFERENCE) {
            if (!as_address && !ir_is_array(node))
                return true;
            return expression_has_load(node->children[0], ir_is_array(node->children[0]));
        }
        return expression_has_load(node->children[0], false);
    case IR_CALL:
    case IR_OPAQUE:
        return true;
    default:
        for (unsigned i = 0; i < node->child_count; i++)
            if (expression_has_load(node->children[i], ir_is_array(node->children[i])))
                return true;
        return false;
    }
}

bool expression_is_lvalue(const ir_node *node) {
    return node->kind == IR_VARIABLE || node->kind == IR_INDEX || node->kind == IR_MEMBER ||
           (node->kind == IR_UNARY && node->op == IR_OP_DEREFERENCE);
}

bool expression_is_scalar_access(const ir_node *node) {
    return node->kind != IR_VARIABLE && expression_is_lvalue(node) && node->type &&
           ir_type_is_scalar(node->type);
}

ir_variable *expression_object(const ir_node *lvalue) {
    while (lvalue->kind == IR_INDEX || lvalue->kind == IR_MEMBER) {
        const ir_node *child = lvalue->children[0];
        bool child_is_pointer = lvalue->kind == IR_INDEX
                                    ? !ir_is_array(child)
                                    : (lvalue->flags & IR_ARROW) != 0 && !ir_is_array(child);
        if (child_is_pointer)
            return NULL;
        lvalue = child;
    }
    return lvalue->kind == IR_VARIABLE ? lvalue->variable : NULL;
}

/* The text of a variable that redcc added is the text of the pointer that it replaces. */
static const char *original_spelling(const ir_node *node, void *memory) {
    return node->kind == IR_VARIABLE && node->variable->stands_for
               ? expression_text(memory, node->variable->stands_for)
               : NULL;
}

const char *expression_text(arena *a, const ir_node *node) {
    buffer text = {0};
    const char *result = "...";
    if (node && ir_is_expression(node) && ir_c_expression(&text, node, original_spelling, a) &&
        text.length)
        result = arena_copy(a, text.data, text.length);
    buffer_free(&text);
    return result;
}

const ir_node *expression_place(const ir_node *node) {
    while (node && ir_is_expression(node))
        node = node->parent;
    return node;
}

bool expression_is_floating_work(const ir_node *node) {
    if (node->kind == IR_BINARY && node->op >= IR_OP_ADD && node->op <= IR_OP_DIVIDE)
        return ir_type_is_floating(node->type);
    if (node->kind == IR_ASSIGN && node->op != IR_OP_NONE)
        return ir_type_is_floating(node->children[0]->type) ||
               ir_type_is_floating(node->children[1]->type);
    if (ir_is_increment(node))
        return ir_type_is_floating(node->type);
    return false;
}

const ir_node *expression_written(const ir_node *node) {
    if (node->kind == IR_ASSIGN || ir_is_increment(node))
        return node->children[0];
    return NULL;
}

ir_operator expression_mirrored(ir_operator op) {
    assert(op >= IR_OP_LESS && op <= IR_OP_NOT_EQUAL);
    switch (op) {
    case IR_OP_LESS:
        return IR_OP_GREATER;
    case IR_OP_LESS_EQUAL:
        return IR_OP_GREATER_EQUAL;
    case IR_OP_GREATER:
        return IR_OP_LESS;
    case IR_OP_GREATER_EQUAL:
        return IR_OP_LESS_EQUAL;
    default:
        return op;
    }
}

ir_operator expression_negated(ir_operator op) {
    switch (op) {
    case IR_OP_LESS:
        return IR_OP_GREATER_EQUAL;
    case IR_OP_LESS_EQUAL:
        return IR_OP_GREATER;
    case IR_OP_GREATER:
        return IR_OP_LESS_EQUAL;
    case IR_OP_GREATER_EQUAL:
        return IR_OP_LESS;
    case IR_OP_EQUAL:
        return IR_OP_NOT_EQUAL;
    case IR_OP_NOT_EQUAL:
        return IR_OP_EQUAL;
    default:
        return IR_OP_NONE;
    }
}

bool variable_is_automatic(const ir_variable *variable) {
    return variable->storage == IR_LOCAL || variable->storage == IR_PARAMETER;
}

/* ---- possibly undefined operations ----------------------------------------------------------- */

static bool is_lvalue_or_number(const ir_node *node) {
    return expression_is_lvalue(node) || node->kind == IR_NUMBER;
}

/* Does the node compute, compare or convert a floating value? The value may be out of range or NaN,
 * and exceptions may trap. */
static bool has_floating_hazard(const ir_node *node) {
    if (ir_type_is_floating(node->type) && !is_lvalue_or_number(node))
        return true;
    if (node->kind == IR_DECLARATOR && node->child_count && node->children[0]->type &&
        ir_type_is_floating(node->children[0]->type))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (ir_type_is_floating(node->children[i]->type) &&
            (node->kind == IR_CAST || node->kind == IR_BINARY || node->kind == IR_ASSIGN ||
             node->kind == IR_INITIALIZERS))
            return true;
    return false;
}

/* Is the right operand a constant for which the operation is defined: a divisor other than 0 and
 * -1, or a shift count less than the type's width? */
static bool is_harmless_operand(const ir_node *node, const ir_node *right) {
    int64_t constant;
    if (!expression_constant(right, &constant))
        return false;
    if (node->op == IR_OP_DIVIDE || node->op == IR_OP_REMAINDER)
        return constant != 0 && constant != -1;
    return constant >= 0 && node->type && constant < node->type->size * 8;
}

bool expression_is_hazard(const ir_node *node) {
    const bool assigns = node->kind == IR_ASSIGN && node->op != IR_OP_NONE;
    if (node->kind == IR_CALL || node->kind == IR_OPAQUE || assigns || ir_is_increment(node) ||
        has_floating_hazard(node))
        return true;
    if (node->kind != IR_BINARY)
        return false;
    if (node->op == IR_OP_DIVIDE || node->op == IR_OP_REMAINDER || node->op == IR_OP_SHIFT_LEFT ||
        node->op == IR_OP_SHIFT_RIGHT)
        return !is_harmless_operand(node, node->children[1]);
    /* the two pointers may point into different objects */
    return node->op == IR_OP_SUBTRACT && node->children[1]->type &&
           node->children[1]->type->kind == IR_POINTER;
}

bool expression_has_hazard(const ir_node *node) {
    return ir_any(node, expression_is_hazard);
}

bool expression_is_assigned(const ir_node *node) {
    const ir_node *parent = node->parent;
    return parent && parent->kind == IR_ASSIGN && parent->op == IR_OP_NONE &&
           parent->children[0] == node;
}

static bool evaluates_parts(const ir_node *node) {
    switch (node->kind) {
    case IR_BLOCK:
    case IR_DECLARATION:
    case IR_DECLARATOR:
    case IR_EXPRESSION:
    case IR_ASSIGN:
    case IR_INDEX:
    case IR_MEMBER:
    case IR_CAST:
        return true;
    case IR_UNARY:
        return node->op != IR_OP_ADDRESS;
    case IR_BINARY:
        return node->op != IR_OP_AND && node->op != IR_OP_OR;
    default:
        return false;
    }
}

bool expression_evaluates(const ir_node *node, const ir_node *part) {
    return evaluates_parts(node) ||
           ((node->kind == IR_BINARY || node->kind == IR_IF) && node->children[0] == part);
}
