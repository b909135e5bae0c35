/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Expressions for all lanes. Arithmetic on doubles is the user's, operator by operator: each is
 * rounded as it is for one iteration. What is read from memory by a subscript of the iteration, or
 * is an integer of it, is gathered.
 */
#include <string.h>

#include "emit/lanes.h"
#include "emit/origin.h"
#include "ir/ir_words.h"

static const lifted nothing = {"0.0", false};

static lifted refuse(const lifter *l, lane_reason why, const ir_node *node) {
    lane_problem(l, why, node);
    return nothing;
}

/* ---- the text of one lane ------------------------------------------------------------------- */

static const char *lifted_place(lifter *l, const ir_node *node) {
    const char *text = text_operand(l->loop->arena, node, NULL, NULL);
    if (!text)
        lane_problem(l, NO_LANES_SPELLING, node);
    return text ? text : "0";
}

const char *lane_rename(const ir_node *node, void *context) {
    lifter *l = context;
    arena *a = l->loop->arena;
    const int array = loop_array_of_base(l->loop, node);
    if (array >= 0 && !l->function)
        return l->loop->arrays[array].local;
    if (node->kind == IR_VARIABLE && l->class_of[node->variable->id] == LANE_VARYING)
        return arena_format(a, "%s[redcc__l]", origin_variable(a, node->variable));
    if (node->kind == IR_VARIABLE && l->class_of[node->variable->id] == LANE_MASK)
        return arena_format(a, "((int)-%s[redcc__l])", origin_variable(a, node->variable));
    if (!lane_is_double(node->type) || !lane_lifted_root(l, node))
        return NULL;
    return arena_format(a, "%s[redcc__l]", lifted_place(l, node));
}

const char *lane_scalar(lifter *l, const ir_node *node) {
    if (lane_has_whole_lifted(l, node))
        lane_problem(l, NO_LANES_ARRAY_AS_POINTER, node);
    const char *text = text_operand(l->loop->arena, node, lane_rename, l);
    if (!text)
        lane_problem(l, NO_LANES_SPELLING, node);
    return text ? text : "0";
}

const char *lane_condition(lifter *l, const ir_node *node) {
    const char *text = text_expression(l->loop->arena, node, lane_rename, l);
    if (!text)
        lane_problem(l, NO_LANES_SPELLING, node);
    return text ? text : "0";
}

lane_reason lane_effect_of(const ir_node *node) {
    if (node->kind == IR_CALL)
        return NO_LANES_CALL;
    for (unsigned i = 0; i < node->child_count; i++)
        if (lane_effect_of(node->children[i]) == NO_LANES_CALL)
            return NO_LANES_CALL;
    return NO_LANES_OPERAND_EFFECT;
}

/** An operand that is read from memory, or an integer, as a double. */
static lifted leaf(lifter *l, const ir_node *node) {
    arena *a = l->loop->arena;
    if (!lane_is_plain(node))
        return refuse(l, lane_effect_of(node), node);
    if (lane_mentions_lifted(l, node))
        return refuse(l, NO_LANES_FROM_DOUBLE, node);
    const char *text = lane_scalar(l, node);
    if (!lane_is_double(node->type))
        text = arena_format(a, "(double)%s", text);
    if (lane_is_uniform(l, node) && (!l->may_be_none || lane_is_safe(l, node)))
        return (lifted){arena_format(a, "(%s)", text), false};
    return (lifted){arena_format(a, "REDCC_GATHER(%s)", lane_guarded(l, node, text)), true};
}

/* ---- arithmetic ----------------------------------------------------------------------------- */

static const char *as_vector(lifter *l, lifted value) {
    return value.is_vector ? value.text
                           : arena_format(l->loop->arena, "redcc_same(%s)", value.text);
}

const char *lane_vector(lifter *l, const ir_node *node) {
    return as_vector(l, lane_expression(l, node));
}

bool lane_has_operator(ir_operator op) {
    return op >= IR_OP_ADD && op <= IR_OP_DIVIDE;
}

static lifted arithmetic(lifter *l, const ir_node *node) {
    if (!lane_has_operator(node->op))
        return refuse(l, NO_LANES_OPERAND_EFFECT, node);
    const lifted left = lane_expression(l, node->children[0]);
    const lifted right = lane_expression(l, node->children[1]);
    return (lifted){arena_format(l->loop->arena, "(%s %s %s)", left.text,
                                 ir_operator_spelling(node->op), right.text),
                    left.is_vector || right.is_vector};
}

bool lane_is_safe(const lifter *l, const ir_node *node) {
    if (lane_is_double(node->type) && lane_lifted_root(l, node))
        return true;
    if (node->kind == IR_INDEX || node->kind == IR_CALL || node->kind == IR_ASSIGN ||
        node->kind == IR_OPAQUE || (node->kind == IR_MEMBER && node->flags & IR_ARROW) ||
        (node->kind == IR_UNARY &&
         (node->op == IR_OP_DEREFERENCE || node->op >= IR_OP_PRE_INCREMENT)))
        return false;
    const bool is_arithmetic = node->kind == IR_BINARY && node->op <= IR_OP_BIT_XOR;
    if (is_arithmetic && !lane_is_double(node->type) && !(node->flags & IR_HAS_VALUE))
        return false; /* of integers: it may overflow, or divide by 0 */
    for (unsigned i = 0; i < node->child_count; i++)
        if (!lane_is_safe(l, node->children[i]))
            return false;
    return true;
}

static lifted conditional(lifter *l, const ir_node *node) {
    arena *a = l->loop->arena;
    const ir_node *condition = node->children[0];
    if (l->may_be_none && !lane_is_safe(l, node))
        return refuse(l, NO_LANES_CHOICE, node);
    if (lane_is_uniform(l, condition)) {
        const lifted yes = lane_expression(l, node->children[1]);
        const lifted no = lane_expression(l, node->children[2]);
        if (!yes.is_vector && !no.is_vector)
            return (lifted){
                arena_format(a, "(%s ? %s : %s)", lane_scalar(l, condition), yes.text, no.text),
                false};
        return (lifted){arena_format(a, "(%s ? %s : %s)", lane_scalar(l, condition),
                                     as_vector(l, yes), as_vector(l, no)),
                        true};
    }
    if (!lane_is_safe(l, condition) || !lane_is_safe(l, node->children[1]) ||
        !lane_is_safe(l, node->children[2]))
        return refuse(l, NO_LANES_CHOICE, node);
    return (lifted){arena_format(a, "redcc_select(%s, %s, %s)", lane_mask(l, condition),
                                 lane_vector(l, node->children[1]),
                                 lane_vector(l, node->children[2])),
                    true};
}

/* ---- calls ---------------------------------------------------------------------------------- */

static lifted call(lifter *l, const ir_node *node) {
    static const char *const known[] = {"sqrt", "fabs"};
    const ir_function *callee =
        node->children[0]->kind == IR_FUNCTION ? node->children[0]->function : NULL;
    if (!callee || !lane_is_double(node->type))
        return refuse(l, NO_LANES_CALL, node);
    if (callee->body)
        return (lifted){lane_call(l, node), true};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (callee->is_from_system && strcmp(callee->name, known[i]) == 0 &&
            !callee->linkage.is_renamed && node->child_count == 2)
            return (lifted){arena_format(l->loop->arena,
                                         l->mask ? "redcc_lanes_%s(redcc_select(%s, %s, "
                                                   "redcc_same(1.0)))"
                                                 : "redcc_lanes_%s(%s%s)",
                                         known[i], l->mask ? l->mask : "",
                                         lane_vector(l, node->children[1])),
                            true};
    return refuse(l, NO_LANES_CALL, node);
}

/* ---- all ------------------------------------------------------------------------------------ */

lifted lane_expression(lifter *l, const ir_node *node) {
    arena *a = l->loop->arena;
    if (!node->type || (!lane_is_double(node->type) && node->type->kind != IR_INTEGER &&
                        node->type->kind != IR_BOOLEAN))
        return refuse(l, NO_LANES_OPERAND_TYPE, node);
    if (!lane_is_double(node->type))
        return leaf(l, node);
    if (lane_lifted_root(l, node))
        return (lifted){lifted_place(l, node), true};
    switch (node->kind) {
    case IR_BINARY:
        return arithmetic(l, node);
    case IR_CONDITIONAL:
        return conditional(l, node);
    case IR_CALL:
        return call(l, node);
    case IR_CAST:
        return lane_expression(l, node->children[0]);
    case IR_UNARY:
        if (node->op == IR_OP_MINUS || node->op == IR_OP_PLUS) {
            const lifted operand = lane_expression(l, node->children[0]);
            return (lifted){
                arena_format(a, "(%s%s)", node->op == IR_OP_MINUS ? "-" : "+", operand.text),
                operand.is_vector};
        }
        return leaf(l, node);
    default:
        return leaf(l, node);
    }
}
