/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Inner loops in vector code: all lanes execute the same iterations.
 */
#include "emit/lanes/vectoriser.h"

#include "plan/unroll.h"
#include <assert.h>

void lane_for(vectoriser *l, const ir_node *node) {
    assert(node->kind == IR_FOR);
    arena *a = l->loop->arena;
    const ir_node *first = node->children[0], *condition = node->children[1],
                  *step = node->children[2];
    const bool declares = first->kind == IR_DECLARATION;
    if (!lane_loop_is_uniform(&l->in, node)) {
        lane_problem(&l->in, NO_LANES_LOOP_INSIDE, node);
        return;
    }
    writer_line(l->out, "{");
    l->out->depth++;
    if (declares)
        lane_statement(l, first);
    const char *begin = declares || first->kind == IR_EMPTY ? "" : lane_scalar(l, first);
    const char *next = step->kind == IR_EMPTY ? "" : text_expression(a, step, lane_rename, l);
    if (!next)
        lane_problem(&l->in, NO_LANES_SPELLING, node);
    writer_line(l->out, "%sfor (%s; %s; %s) {",
                is_unrolled_computation(node) ? "REDCC_UNROLLED " : "", begin,
                lane_condition(l, condition), next ? next : "");
    lane_part(l, node->children[3]);
    l->out->depth--;
    writer_line(l->out, "}");
}
