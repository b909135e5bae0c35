/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/work.h"

#include <assert.h>

#include "analysis/base/counted.h"
#include "plan/lookup.h"

enum {
    EXPENSIVE = 8,    /* cost of a floating-point division, or of a call with a floating result */
    UNKNOWN_TRIP = 4, /* assumed iterations of an inner loop with an unknown trip count */
    MOST_DEPTH = 8,   /* nesting depth of calls */
    MOST_WORK = 10000 /* counting stops here */
};

int64_t work_constant_trip(const ir_node *loop) {
    assert(ir_is_loop(loop));
    const ir_variable *counter;
    int64_t first, last;
    if (!counted_constant(loop, &counter, &first, &last))
        return 0;
    const int64_t trip = last - first + 1;
    return trip <= MOST_WORK ? trip : 0;
}

static int64_t own_work(const ir_node *node) {
    const bool is_operation = node->kind == IR_BINARY || node->kind == IR_ASSIGN;
    if (node->kind == IR_CALL)
        return ir_type_is_floating(node->type) ? EXPENSIVE : 0;
    if (node->kind == IR_UNARY)
        return node->op == IR_OP_MINUS && ir_type_is_floating(node->type);
    if (!is_operation || node->op == IR_OP_NONE || !ir_type_is_floating(node->children[0]->type))
        return 0;
    return node->op == IR_OP_DIVIDE ? EXPENSIVE : 1;
}

/** The cost of functions, by id and depth of the call, or -1 if it is not computed yet. */
typedef struct known_work {
    int64_t (*of)[MOST_DEPTH + 1];
} known_work;

static int64_t work_of(const known_work *known, const ir_node *node, int depth);

static int64_t work_of_callee(const known_work *known, const ir_function *callee, int depth) {
    int64_t *work = &known->of[callee->id][depth];
    if (*work < 0)
        *work = work_of(known, callee->body, depth);
    return *work;
}

static int64_t work_of(const known_work *known, const ir_node *node, int depth) {
    int64_t work = own_work(node);
    const ir_function *callee = node->kind == IR_CALL && node->children[0]->kind == IR_FUNCTION
                                    ? node->children[0]->function
                                    : NULL;
    if (callee && callee->body && depth < MOST_DEPTH)
        work += work_of_callee(known, callee, depth + 1);
    for (unsigned i = 0; i < node->child_count && work < MOST_WORK; i++)
        work += work_of(known, node->children[i], depth);
    if (ir_is_loop(node)) {
        const int64_t trip = work_constant_trip(node);
        work *= trip ? trip : UNKNOWN_TRIP;
    }
    return work < MOST_WORK ? work : MOST_WORK;
}

int64_t work_of_statement(const loop_plan *plan, const ir_node *statement) {
    const unsigned count = plan->unit->function_count;
    const known_work known = {.of = arena_allocate(plan->arena, (count + 1) * sizeof *known.of)};
    for (unsigned i = 0; i < count; i++)
        for (int depth = 0; depth <= MOST_DEPTH; depth++)
            known.of[i][depth] = -1;
    return work_of(&known, statement, 0);
}

int64_t work_of_iteration(const loop_plan *plan) {
    return work_of_statement(plan, plan->facts->counted.body);
}

/* ---- outside of updates ---------------------------------------------------------------------- */

static int64_t size_of(const ir_node *node, int depth) {
    const ir_function *callee = node->kind == IR_CALL && node->children[0]->kind == IR_FUNCTION
                                    ? node->children[0]->function
                                    : NULL;
    int64_t size = ir_is_expression(node);
    if (callee && callee->body && depth < MOST_DEPTH)
        size += size_of(callee->body, depth + 1);
    for (unsigned i = 0; i < node->child_count && size < MOST_WORK; i++)
        size += size_of(node->children[i], depth);
    if (ir_is_loop(node)) {
        const int64_t trip = work_constant_trip(node);
        size *= trip ? trip : UNKNOWN_TRIP;
    }
    return size < MOST_WORK ? size : MOST_WORK;
}

int64_t work_outside_updates(const loop_plan *plan, const ir_node *statement) {
    const int64_t trip = ir_is_loop(statement) ? work_constant_trip(statement) : 1;
    int64_t size = 0;
    if (loop_update_at(plan->facts, statement))
        return 0;
    if (ir_is_expression(statement) || statement->kind == IR_EXPRESSION ||
        statement->kind == IR_DECLARATION)
        return size_of(statement, 0);
    /* unrolling removes the header of a loop with constant bounds, so only its body counts */
    for (unsigned i = ir_is_loop(statement) && trip ? 3 : 0; i < statement->child_count; i++)
        size += work_outside_updates(plan, statement->children[i]);
    return size * (trip ? trip : UNKNOWN_TRIP);
}
