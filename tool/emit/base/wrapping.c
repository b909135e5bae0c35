/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Expressions that generated code may evaluate although the program does not: under fewer
 * conditions than in the loop, or before it. In that case their values do not matter, but they must
 * be defined. So signed arithmetic wraps around, and addresses are numbers, which may lie outside
 * of every object.
 */
#include "emit/base/wrapping.h"

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "emit/text/origin.h"
#include "ir/ir_words.h"
#include "plan/unconditional.h"

/* ---- arithmetic ---------------------------------------------------------------------------- */

static bool is_integer(const ir_node *node) {
    return node->type && (node->type->kind == IR_INTEGER || node->type->kind == IR_BOOLEAN);
}

/** Does the operator on unsigned operands give the signed result whenever the signed result is
 * defined? */
static bool wraps_around(ir_operator op) {
    return op == IR_OP_ADD || op == IR_OP_SUBTRACT || op == IR_OP_MULTIPLY ||
           op == IR_OP_SHIFT_LEFT;
}

const char *wrapping_operation(arena *a, const ir_node *node, ir_c_rename rename, void *context) {
    if (!node->type || node->type->kind != IR_INTEGER || !node->type->is_signed ||
        node->flags & IR_HAS_VALUE)
        return NULL;
    const char *type = node->type->size == 8 ? "redcc_int" : "int";
    const char *within = node->type->size == 8 ? "redcc_word" : "redcc_u32";
    if (node->kind == IR_UNARY && node->op == IR_OP_MINUS) {
        const char *only = text_operand(a, node->children[0], rename, context);
        return only ? origin_value(a, node->type,
                                   arena_format(a, "((%s)(0 - (%s)%s))", type, within, only))
                    : NULL;
    }
    if (node->kind != IR_BINARY || !wraps_around(node->op) || !is_integer(node->children[0]) ||
        !is_integer(node->children[1]))
        return NULL;
    const char *left = text_operand(a, node->children[0], rename, context);
    const char *right = text_operand(a, node->children[1], rename, context);
    if (!left || !right)
        return NULL;
    return origin_value(a, node->type,
                        node->op == IR_OP_SHIFT_LEFT
                            ? arena_format(a, "((%s)((%s)%s << %s))", type, within, left, right)
                            : arena_format(a, "((%s)((%s)%s %s (%s)%s))", type, within, left,
                                           ir_operator_spelling(node->op), within, right));
}

/* ---- addresses ----------------------------------------------------------------------------- */

/** Returns the text of the subscript, computed in 64 bits. The subscript increases by a constant
 * with the counter of a span, an inner loop that is logged as one range. It contains only
 * operations that steps_with in analysis/base/row_steps.c accepts. */
static const char *wide_number(arena *a, const ir_node *node, const ir_variable *counter,
                               ir_c_rename rename, void *context) {
    if (node->kind == IR_CAST && expression_mentions(node, counter))
        return wide_number(a, node->children[0], counter, rename, context);
    if (node->kind == IR_BINARY && expression_mentions(node, counter)) {
        const char *left = wide_number(a, node->children[0], counter, rename, context);
        const char *right = wide_number(a, node->children[1], counter, rename, context);
        return left && right && wraps_around(node->op)
                   ? arena_format(a, "(%s %s %s)", left, ir_operator_spelling(node->op), right)
                   : NULL;
    }
    const char *text = text_operand(a, node, rename, context);
    return text ? arena_format(a, "(redcc_size)%s", text) : NULL;
}

const char *address_number(arena *a, const row_address *address, const ir_variable *counter,
                           ir_c_rename rename, void *context) {
    const char *sum = text_operand(a, address->base, rename, context);
    if (!sum)
        return NULL;
    sum = arena_format(a, "(redcc_size)%s%s", row_needs_address(address) ? "&" : "", sum);
    for (unsigned i = 0; i < address->term_count; i++) {
        const row_term *term = &address->terms[i];
        const bool is_down = term->bytes < 0;
        const char *number =
            wide_number(a, term->subscript,
                        counter && expression_mentions(term->subscript, counter) ? counter : NULL,
                        rename, context);
        if (!number)
            return NULL;
        sum = arena_format(a, "%s %s %lldu * %s", sum, is_down ? "-" : "+",
                           (long long)(is_down ? -term->bytes : term->bytes), number);
    }
    if (address->offset != 0)
        sum = arena_format(a, "%s + %lldu", sum, (long long)address->offset);
    return sum;
}
