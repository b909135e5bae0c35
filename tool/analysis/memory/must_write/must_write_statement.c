/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/memory/must_write/must_write_run.h"

enum {
    /* At most this many iterations of a loop are interpreted one by one. */
    MOST_ITERATIONS = 1 << 14
};

static state *scratch_copy(run *r, const state *s) {
    state *copy = ARENA_NEW(r->prover->scratch, state);
    *copy = state_copy(r->prover->scratch, s);
    return copy;
}

static void join(run *r, const ir_node *node, state *s, const state *other) {
    if (run_step(r, node, state_weight(other)))
        state_join(r->prover->scratch, s, other);
}

/* Joins *s into *to, the state at the jump's target, and marks *s as unreachable. Gives up if `to`
 * is NULL. */
static void jump(run *r, const ir_node *node, state *s, state *to) {
    if (to == NULL) {
        run_give_up(r, node, "a jump leaves the analysed code");
        return;
    }
    join(r, node, to, s);
    s->is_reachable = false;
}

static void execute_if(run *r, state *s, const ir_node *node) {
    const value condition = run_evaluate(r, s, node->children[0]);
    const ir_node *then = node->children[1], *otherwise = ir_child(node, 2);
    if (condition.kind == VALUE_INTEGER) {
        if (condition.number != 0)
            run_execute(r, s, then);
        else if (otherwise != NULL)
            run_execute(r, s, otherwise);
        return;
    }
    if (!run_step(r, node, state_weight(s)))
        return;
    state *other = scratch_copy(r, s);
    run_execute(r, s, then);
    if (otherwise != NULL)
        run_execute(r, other, otherwise);
    join(r, node, s, other);
}

/* ---- loops --------------------------------------------------------------------------------- */

typedef struct loop_parts {
    const ir_node *condition; /* NULL if the condition is always true */
    const ir_node *increment; /* NULL if there is none */
    const ir_node *body;
    const ir_node *counted; /* the loop, if it is an IR_FOR; otherwise NULL */
} loop_parts;

/* Executes the body and the increment. States at a break are joined into *breaks. */
static void execute_iteration(run *r, state *s, const loop_parts *loop, state *breaks) {
    state *const outer_break = r->on_break, *const outer_continue = r->on_continue;
    state continues = {.is_reachable = false};
    r->on_break = breaks;
    r->on_continue = &continues;
    run_execute(r, s, loop->body);
    join(r, loop->body, s, &continues);
    r->on_break = outer_break;
    r->on_continue = outer_continue;
    if (s->is_reachable && loop->increment != NULL)
        run_discard(r, s, loop->increment);
}

static value evaluate_condition(run *r, state *s, const loop_parts *loop) {
    const value always = {VALUE_INTEGER, true, 1};
    return loop->condition == NULL ? always : run_evaluate(r, s, loop->condition);
}

/* Executes an unknown number of iterations, beginning before the condition. Writes of one iteration
 * do not count in later ones. The values of variables are joined until they no longer change. */
static void execute_any_iterations(run *r, state *s, const loop_parts *loop, state *breaks) {
    state *head = scratch_copy(r, s);
    while (r->unknown == NULL) {
        *s = state_copy(r->prover->scratch, head);
        const value condition = evaluate_condition(r, s, loop);
        const bool is_endless = condition.kind == VALUE_INTEGER && condition.number != 0;
        if (condition.kind == VALUE_INTEGER && condition.number == 0)
            return; /* `head` is still the state before the first iteration, so there is no
                     * iteration */
        state *iteration = scratch_copy(r, s);
        execute_iteration(r, iteration, loop, breaks);
        state *next = scratch_copy(r, head);
        join(r, loop->body, next, iteration);
        s->is_reachable = s->is_reachable && !is_endless;
        if (!run_step(r, loop->body, 4 * state_weight(head)) || state_same_bindings(next, head))
            return;
        head = next;
    }
}

static state *bindings_copy(run *r, const state *s) {
    const state bindings = {
        .is_reachable = true,
        .bindings = {s->bindings.items, s->bindings.count, s->bindings.capacity}};
    return scratch_copy(r, &bindings);
}

/* If the trip count is known although the condition is not, and is at most MOST_ITERATIONS,
 * executes the iterations and returns true. */
static bool execute_known_iterations(run *r, state *s, const loop_parts *loop, state *breaks) {
    const int64_t iterations =
        loop->counted && run_step(r, loop->body, 64) ? run_known_trip_count(r, loop->counted) : -1;
    if (iterations < 0 || iterations > MOST_ITERATIONS)
        return false;
    for (int64_t iteration = 0; iteration < iterations && s->is_reachable && r->unknown == NULL;
         iteration++) {
        execute_iteration(r, s, loop, breaks);
        if (s->is_reachable)
            evaluate_condition(r, s, loop);
    }
    return true;
}

/* Executes the loop from its condition on, one iteration after the other while the condition's
 * value is known. */
static void execute_loop(run *r, state *s, const loop_parts *loop, state *breaks) {
    const bool has_effects = loop->condition != NULL && run_has_effects(r, loop->condition);
    byte_set repeated = {NULL, 0}; /* the bytes that had been written when an iteration last left
                                    * all variables unchanged */
    for (unsigned iteration = 0; s->is_reachable && r->unknown == NULL; iteration++) {
        state *before = has_effects ? scratch_copy(r, s) : bindings_copy(r, s);
        if (!run_step(r, loop->body, state_weight(before)))
            return;
        const value condition = evaluate_condition(r, s, loop);
        if (condition.kind == VALUE_INTEGER && condition.number == 0)
            return;
        if (condition.kind != VALUE_INTEGER && iteration == 0 && !has_effects &&
            execute_known_iterations(r, s, loop, breaks))
            return;
        if (condition.kind != VALUE_INTEGER || iteration == MOST_ITERATIONS) {
            if (has_effects)
                *s = *before; /* continues from the state before the condition */
            execute_any_iterations(r, s, loop, breaks);
            return;
        }
        execute_iteration(r, s, loop, breaks);
        if (!s->is_reachable || !state_same_bindings(s, before))
            continue;
        if (repeated.words != NULL && byte_set_includes(repeated, s->written)) {
            s->is_reachable = false; /* further iterations repeat this one, so only a break ends
                                      * the loop */
            return;
        }
        if (run_step(r, loop->body, state_weight(s)))
            repeated = byte_set_copy(r->prover->scratch, s->written);
    }
}

static void execute_loop_statement(run *r, state *s, const ir_node *node) {
    loop_parts loop = {NULL, NULL, NULL, NULL};
    state breaks = {.is_reachable = false};
    if (node->kind == IR_FOR) {
        const ir_node *first = node->children[0];
        if (first->kind == IR_DECLARATION || first->kind == IR_EMPTY)
            run_execute(r, s, first);
        else
            run_discard(r, s, first->kind == IR_EXPRESSION ? first->children[0] : first);
        if (node->children[1]->kind != IR_EMPTY)
            loop.condition = node->children[1];
        if (node->children[2]->kind != IR_EMPTY)
            loop.increment = node->children[2];
        loop.body = node->children[3];
        loop.counted = node;
    } else if (node->kind == IR_WHILE) {
        loop.condition = node->children[0];
        loop.body = node->children[1];
    } else {
        loop.body = node->children[0];
        loop.condition = node->children[1];
        execute_iteration(r, s, &loop, &breaks);
    }
    execute_loop(r, s, &loop, &breaks);
    join(r, node, s, &breaks);
}

/* ---- switch -------------------------------------------------------------------------------- */

typedef struct switch_labels {
    const ir_node *node;
    bool has_default;
    bool is_nested; /* a label is inside an inner statement, which is therefore entered by a
                     * jump */
} switch_labels;

static bool note_label(ir_node *node, void *context) {
    switch_labels *labels = context;
    if (node->kind == IR_SWITCH && node != labels->node)
        return false;
    if (node->kind != IR_CASE && node->kind != IR_DEFAULT)
        return true;
    labels->has_default = labels->has_default || node->kind == IR_DEFAULT;
    const ir_node *above = node->parent;
    while (above != NULL && (above->kind == IR_CASE || above->kind == IR_DEFAULT))
        above = above->parent;
    if (above != labels->node && (above == NULL || above->parent != labels->node ||
                                  above->kind != IR_BLOCK || above != labels->node->children[1]))
        labels->is_nested = true;
    return true;
}

static void execute_labelled(run *r, state *s, const ir_node *node, const state *entry) {
    while (node->kind == IR_CASE || node->kind == IR_DEFAULT) {
        join(r, node, s, entry);
        node = node->children[node->child_count - 1];
    }
    run_execute(r, s, node);
}

static void execute_switch(run *r, state *s, const ir_node *node) {
    switch_labels labels = {node, false, false};
    const ir_node *body = node->children[1];
    ir_walk((ir_node *)node, note_label, &labels);
    if (labels.is_nested) {
        run_give_up(r, node, "a case label is inside an inner statement");
        return;
    }
    run_evaluate(r, s, node->children[0]);
    if (!run_step(r, node, 2 * state_weight(s)))
        return;
    state *const outer_break = r->on_break;
    state breaks = {.is_reachable = false};
    const state *entry = scratch_copy(r, s);
    r->on_break = &breaks;
    s->is_reachable = false; /* the text before the first label is not executed */
    if (body->kind == IR_BLOCK)
        for (unsigned i = 0; i < body->child_count; i++)
            execute_labelled(r, s, body->children[i], entry);
    else
        execute_labelled(r, s, body, entry);
    r->on_break = outer_break;
    join(r, node, s, &breaks);
    if (!labels.has_default)
        join(r, node, s, entry);
}

/* ---- statements ---------------------------------------------------------------------------- */

static void execute_return(run *r, state *s, const ir_node *node) {
    if (node->child_count > 0) {
        const value v = run_evaluate(r, s, node->children[0]);
        r->result = r->has_result ? value_join(r->result, v) : v;
        r->has_result = true;
    }
    jump(r, node, s, &r->on_return);
}

void run_execute(run *r, state *s, const ir_node *node) {
    if (!s->is_reachable || !run_step(r, node, 1))
        return;
    switch (node->kind) {
    case IR_BLOCK:
        for (unsigned i = 0; i < node->child_count; i++)
            run_execute(r, s, node->children[i]);
        break;
    case IR_DECLARATION:
        for (unsigned i = 0; i < node->child_count; i++)
            run_initialise(r, s, node->children[i]);
        break;
    case IR_DECLARATOR:
        run_initialise(r, s, node);
        break;
    case IR_EXPRESSION:
        run_discard(r, s, node->children[0]);
        break;
    case IR_IF:
        execute_if(r, s, node);
        break;
    case IR_FOR:
    case IR_WHILE:
    case IR_DO:
        execute_loop_statement(r, s, node);
        break;
    case IR_SWITCH:
        execute_switch(r, s, node);
        break;
    case IR_RETURN:
        execute_return(r, s, node);
        break;
    case IR_BREAK:
        jump(r, node, s, r->on_break);
        break;
    case IR_CONTINUE:
        jump(r, node, s, r->on_continue);
        break;
    case IR_EMPTY:
        break;
    case IR_LABEL:
    case IR_GOTO:
    case IR_CASE:
    case IR_DEFAULT:
        run_give_up(r, node, "labels and goto are not followed");
        break;
    default:
        if (ir_is_expression(node))
            run_discard(r, s, node);
        else
            run_give_up(r, node, "it contains a construct that is not understood");
    }
}
