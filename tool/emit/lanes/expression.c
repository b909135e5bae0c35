/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Expressions for all lanes. Arithmetic on doubles and floats follows the user's operators: each
 * operation is computed in its own type and rounded as in a single iteration. Operands that differ
 * between lanes, are read from memory or are converted from integers are gathered into vectors.
 */
#include "emit/lanes/vectoriser.h"
#include "emit/text/origin.h"
#include "ir/ir_words.h"
#include "plan/lane_calls.h"
#include "plan/lookup.h"

static const lane_value nothing = {"0.0", false};

static lane_value refuse(const vectoriser *l, lane_reason why, const ir_node *node) {
    lane_problem(&l->in, why, node);
    return nothing;
}

/* ---- the text of one lane ------------------------------------------------------------------- */

static const char *operand(vectoriser *l, const ir_node *node, ir_c_rename rename) {
    const char *text = text_operand(l->loop->arena, node, rename, l);
    if (!text)
        lane_problem(&l->in, NO_LANES_SPELLING, node);
    return text ? text : "0";
}

/** A rename hook that spells reduction arrays, integers and pointers for lane redcc__l. */
static const char *rename_integer(const ir_node *node, void *context) {
    vectoriser *l = context;
    arena *a = l->loop->arena;
    const int array = loop_array_of_base(l->loop->facts, node);
    if (array >= 0 && !l->in.function)
        return l->loop->arrays[array].local;
    if (node->kind == IR_VARIABLE && l->in.class_of[node->variable->id] == LANE_VARYING)
        return origin_value(a, node->type,
                            arena_format(a, "%s[redcc__l]", origin_variable(a, node->variable)));
    if (node->kind == IR_VARIABLE && l->in.class_of[node->variable->id] == LANE_MASK)
        return origin_value(a, node->type,
                            arena_format(a, "((%s)-%s[redcc__l])", lane_type(l, node->type),
                                         origin_variable(a, node->variable)));
    return NULL;
}

const char *lane_rename(const ir_node *node, void *context) {
    vectoriser *l = context;
    if (!lane_is_real(node->type) || !lane_vector_element(&l->in, node))
        return rename_integer(node, l);
    return origin_value(
        l->loop->arena, node->type,
        arena_format(l->loop->arena, "%s[redcc__l]", operand(l, node, rename_integer)));
}

const char *lane_scalar(vectoriser *l, const ir_node *node) {
    if (lane_has_whole_vector(&l->in, node))
        lane_problem(&l->in, NO_LANES_ARRAY_AS_POINTER, node);
    return operand(l, node, lane_rename);
}

const char *lane_condition(vectoriser *l, const ir_node *node) {
    const char *text = text_expression(l->loop->arena, node, lane_rename, l);
    if (!text)
        lane_problem(&l->in, NO_LANES_SPELLING, node);
    return text ? text : "0";
}

/** An operand that is not a vector: a floating value read from memory, or an integer converted to
 * `type`. */
static lane_value leaf(vectoriser *l, const ir_node *node, const ir_type *type) {
    arena *a = l->loop->arena;
    if (!lane_is_plain(node))
        return refuse(l, lane_effect_of(node), node);
    if (lane_mentions_vector(&l->in, node) && !lane_vector_element(&l->in, node))
        return refuse(l, NO_LANES_FROM_DOUBLE, node);
    const char *text = lane_scalar(l, node);
    if (!lane_is_real(node->type))
        text = arena_format(a, "(%s)%s", lane_words_of(type)->scalar, text);
    if (lane_is_uniform(&l->in, node) && (!l->may_be_none || lane_is_safe(&l->in, node)))
        return (lane_value){arena_format(a, "(%s)", text), false};
    return (lane_value){
        arena_format(a, "%s(%s)", lane_words_of(type)->gather, lane_masked(l, node, text)), true};
}

/* ---- arithmetic ----------------------------------------------------------------------------- */

const char *lane_vector(vectoriser *l, const ir_node *node, const ir_type *to) {
    return lane_spread(l, lane_expression(l, node, to), to);
}

static lane_value arithmetic(vectoriser *l, const ir_node *node) {
    if (!lane_has_operator(node->op))
        return refuse(l, NO_LANES_OPERAND_EFFECT, node);
    const lane_value left = lane_expression(l, node->children[0], node->type);
    const lane_value right = lane_expression(l, node->children[1], node->type);
    return (lane_value){arena_format(l->loop->arena, "(%s %s %s)", left.text,
                                     ir_operator_spelling(node->op), right.text),
                        left.is_vector || right.is_vector};
}

/** A conditional expression (?:), with its operands converted to `type`. */
static lane_value conditional(vectoriser *l, const ir_node *node, const ir_type *type) {
    arena *a = l->loop->arena;
    const ir_node *condition = node->children[0];
    if (l->may_be_none && !lane_is_safe(&l->in, node))
        return refuse(l, NO_LANES_CHOICE, node);
    if (lane_is_uniform(&l->in, condition)) {
        const lane_value yes = lane_expression(l, node->children[1], type);
        const lane_value no = lane_expression(l, node->children[2], type);
        if (!yes.is_vector && !no.is_vector)
            return (lane_value){
                arena_format(a, "(%s ? %s : %s)", lane_scalar(l, condition), yes.text, no.text),
                false};
        return (lane_value){arena_format(a, "(%s ? %s : %s)", lane_scalar(l, condition),
                                         lane_spread(l, yes, type), lane_spread(l, no, type)),
                            true};
    }
    if (!lane_is_safe(&l->in, condition) || !lane_is_safe(&l->in, node->children[1]) ||
        !lane_is_safe(&l->in, node->children[2]))
        return refuse(l, NO_LANES_CHOICE, node);
    return (lane_value){arena_format(a, "%s(%s, %s, %s)", lane_words_of(type)->select,
                                     lane_mask(l, condition),
                                     lane_vector(l, node->children[1], type),
                                     lane_vector(l, node->children[2], type)),
                        true};
}

/* ---- calls ---------------------------------------------------------------------------------- */

/** Returns a call of the vector form of a library function. In inactive lanes the operand is 1, for
 * which no such function sets errno. */
static lane_value known_call(vectoriser *l, const char *name, const ir_node *call) {
    arena *a = l->loop->arena;
    const lane_words *words = lane_words_of(call->type);
    const char *operand = lane_vector(l, call->children[1], call->type);
    if (l->mask)
        operand = arena_format(a, "%s(%s, %s, %s((%s)1))", words->select, l->mask, operand,
                               words->same, words->scalar);
    return (lane_value){arena_format(a, "redcc_lanes_%s(%s)", name, operand), true};
}

/** A call of a function without a vector form: it is made for one active lane after the other. */
static lane_value call_by_lane(vectoriser *l, const ir_node *node) {
    arena *a = l->loop->arena;
    const lane_words *words = lane_words_of(node->type);
    buffer given = {0}, arguments = {0};
    for (unsigned i = 1; i < node->child_count; i++) {
        buffer_format(&given, "const %s redcc__given_%u = %s; ", words->vector, i,
                      lane_vector(l, node->children[i], node->type));
        buffer_format(&arguments, "%sredcc__given_%u[redcc__l]", i > 1 ? ", " : "", i);
    }
    const char *text =
        arena_format(a, "%s(%s)", operand(l, node->children[0], NULL), buffer_take(a, &arguments));
    return (lane_value){arena_format(a, "__extension__({ %s%s(%s); })", buffer_take(a, &given),
                                     words->gather, lane_masked(l, node, text)),
                        true};
}

static lane_value call(vectoriser *l, const ir_node *node) {
    const ir_function *callee = ir_called_function(node);
    if (callee && callee->body)
        return (lane_value){lane_call(l, node), true};
    if (callee && lane_known_call(callee) && node->child_count == 2)
        return known_call(l, callee->name, node);
    return lane_may_call(l->loop->unit, node) ? call_by_lane(l, node)
                                              : refuse(l, NO_LANES_CALL, node);
}

/* ---- all ------------------------------------------------------------------------------------ */

/** The expression in its own type, which satisfies lane_is_real. */
static lane_value real_expression(vectoriser *l, const ir_node *node) {
    if (lane_vector_root(&l->in, node))
        return (lane_value){operand(l, node, NULL), true};
    switch (node->kind) {
    case IR_BINARY:
        return arithmetic(l, node);
    case IR_CONDITIONAL:
        return conditional(l, node, node->type);
    case IR_CALL:
        return call(l, node);
    case IR_CAST:
        return lane_expression(l, node->children[0], node->type);
    case IR_UNARY:
        if (node->op == IR_OP_MINUS || node->op == IR_OP_PLUS) {
            const lane_value operand = lane_expression(l, node->children[0], node->type);
            return (lane_value){arena_format(l->loop->arena, "(%s%s)",
                                             node->op == IR_OP_MINUS ? "-" : "+", operand.text),
                                operand.is_vector};
        }
        return leaf(l, node, node->type);
    default:
        return leaf(l, node, node->type);
    }
}

lane_value lane_expression(vectoriser *l, const ir_node *node, const ir_type *to) {
    const ir_type *type = node->type;
    if (lane_is_real(type))
        return lane_convert(l, real_expression(l, node), type, to);
    if (type && type->kind == IR_INTEGER && lane_is_integer_choice(&l->in, node))
        return conditional(l, node, to);
    if (!type || (type->kind != IR_INTEGER && type->kind != IR_BOOLEAN))
        return refuse(l, NO_LANES_OPERAND_TYPE, node);
    return leaf(l, node, to);
}
