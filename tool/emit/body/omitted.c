/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/body/omitted.h"

#include "analysis/base/loop_exits.h"
#include "ir/ir_syntax.h"
#include "plan/lookup.h"

/** The statement with the counter's step; NULL if the header steps it. */
static const ir_node *step_of(const loop_text *loop) {
    const ir_node *increment = body_increment(loop->facts);
    return increment ? syntax_enclosing_statement(increment, loop->facts->counted.body) : NULL;
}

bool is_step(const loop_text *loop, const ir_node *statement) {
    return statement == step_of(loop);
}

static void drop_step(body_copy *copy) {
    const ir_node *step = step_of(copy->loop);
    if (step && !is_printed(copy, step))
        replace_bytes(copy, step->range.begin, syntax_statement_end(copy->loop->unit->source, step),
                      "");
}

static void drop_distributed_stores(body_copy *copy) {
    const distribution *stores = copy->loop->facts->distribution;
    for (unsigned i = 0; stores && i < stores->count; i++) {
        const ir_node *store = stores->stores[i].statement;
        if (!is_printed(copy, store))
            replace_bytes(copy, store->range.begin,
                          syntax_statement_end(copy->loop->unit->source, store), "{ }");
    }
}

static void drop_exits(body_copy *copy) {
    const loop_exits *exits = copy->loop->facts->slice.exits;
    for (unsigned i = 0; exits && i < exits->count; i++) {
        const ir_node *exit = exits->items[i].statement;
        if (exit->kind == IR_EMPTY) /* the exit of a loop without a bound has no text in the body */
            continue;
        if (is_printed(copy, exits->items[i].rest))
            continue;
        if (exits->items[i].is_kept)
            exit = exit->children[1];
        replace_bytes(copy, exit->range.begin, syntax_statement_end(copy->loop->unit->source, exit),
                      "{ }");
    }
}

/** Prints the blocks around exits of a macro's expansion, without these. */
static void print_around_exits(body_copy *copy) {
    const loop_exits *exits = copy->loop->facts->slice.exits;
    for (unsigned i = 0; exits && i < exits->count; i++)
        if (exits->items[i].is_shared)
            print_instead(copy, exits->items[i].parent);
}

/** Prints the statements around dead code in a macro's expansion. Such dead code cannot be dropped
 * by editing bytes, and may name variables that the copy does not get. */
static void print_dead_in_macros(body_copy *copy, const ir_node *node) {
    if ((node->flags & (IR_DEAD | IR_FROM_MACRO)) == (IR_DEAD | IR_FROM_MACRO))
        print_instead(copy, node->parent);
    for (unsigned i = 0; !ir_is_expression(node) && i < node->child_count; i++)
        print_dead_in_macros(copy, node->children[i]);
}

static void drop_dead(body_copy *copy, const ir_node *node) {
    if (node->flags & IR_DEAD && !is_printed(copy, node))
        replace_bytes(copy, node->range.begin, node->range.end, "{ }");
    for (unsigned i = 0; !ir_is_expression(node) && i < node->child_count; i++)
        drop_dead(copy, node->children[i]);
}

void print_around_omitted(body_copy *copy) {
    print_dead_in_macros(copy, copy->loop->facts->counted.body);
    print_around_exits(copy);
}

void drop_omitted(body_copy *copy) {
    drop_step(copy);
    drop_distributed_stores(copy);
    drop_exits(copy);
    drop_dead(copy, copy->loop->facts->counted.body);
}
