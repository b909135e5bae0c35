/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loops inside what is written for vectors: their iterations are the same for all lanes.
 */
#include "emit/lifter.h"
#include "plan/unroll.h"

static bool is_uniform_step(lifter *l, const ir_node *node) {
    if (node->kind == IR_EMPTY)
        return true;
    if (node->kind == IR_BINARY && node->op == IR_OP_COMMA)
        return is_uniform_step(l, node->children[0]) && is_uniform_step(l, node->children[1]);
    return (ir_is_increment(node) || node->kind == IR_ASSIGN) &&
           node->children[0]->kind == IR_VARIABLE && lane_is_own(l, node->children[0]->variable) &&
           l->class_of[node->children[0]->variable->id] == LANE_UNIFORM &&
           (ir_is_increment(node) || lane_is_uniform(l, node->children[1]));
}

void lane_for(lifter *l, const ir_node *node) {
    arena *a = l->loop->arena;
    const ir_node *first = node->children[0], *condition = node->children[1],
                  *step = node->children[2];
    const bool declares = first->kind == IR_DECLARATION;
    bool is_uniform = (condition->kind == IR_EMPTY || lane_is_uniform(l, condition)) &&
                      is_uniform_step(l, step) && (declares || is_uniform_step(l, first));
    for (unsigned i = 0; declares && i < first->child_count; i++)
        is_uniform &= l->class_of[first->children[i]->variable->id] == LANE_UNIFORM;
    if (!is_uniform || condition->kind == IR_EMPTY) {
        lane_problem(l, NO_LANES_LOOP_INSIDE, node);
        return;
    }
    writer_line(l->out, "{");
    l->out->depth++;
    if (declares)
        lane_statement(l, first);
    const char *begin = declares || first->kind == IR_EMPTY ? "" : lane_scalar(l, first);
    const char *next = step->kind == IR_EMPTY ? "" : text_expression(a, step, lane_rename, l);
    if (!next)
        lane_problem(l, NO_LANES_SPELLING, node);
    writer_line(l->out, "%sfor (%s; %s; %s) {",
                is_unrolled_computation(node) ? "REDCC_UNROLLED " : "", begin,
                lane_condition(l, condition), next ? next : "");
    lane_part(l, node->children[3]);
    l->out->depth--;
    writer_line(l->out, "}");
}
