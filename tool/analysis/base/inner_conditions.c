/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/inner_conditions.h"

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "analysis/base/new_nodes.h"

typedef struct moved_condition {
    ir_node *loop, *header, *condition, *body, *block;
} moved_condition;

struct inner_conditions {
    VECTOR(moved_condition) items;
};

static unsigned header_of(const ir_node *loop) {
    return loop->kind == IR_FOR ? 1 : 0;
}

static unsigned body_of(const ir_node *loop) {
    return loop->kind == IR_FOR ? 3 : 1;
}

static bool is_of_macro(const ir_node *node) {
    return node->flags & (IR_FROM_MACRO | IR_FROM_CALL);
}

static bool may_move(ir_node *loop) {
    if ((loop->kind != IR_FOR && loop->kind != IR_WHILE) || loop->flags & IR_OPENED)
        return false;
    const ir_node *header = loop->children[header_of(loop)];
    const counted_result counted = counted_recognise_analysed(loop);
    return header->kind != IR_EMPTY && !ir_any(loop, is_of_macro) &&
           expression_has_load(new_nodes_expression(header), false) &&
           (!counted.is_counted || counted_steps_by_statement(loop, &counted.loop));
}

static void move(inner_conditions *moved, arena *a, const source *text, ir_function *function,
                 ir_node *loop) {
    moved_condition it = {.loop = loop,
                          .header = loop->children[header_of(loop)],
                          .body = loop->children[body_of(loop)]};
    it.condition = (ir_node *)new_nodes_expression(it.header);
    const node_maker m = new_nodes_for(a, function, it.header, it.body);
    it.block = new_block_around(&m, text, it.body, 1);
    ir_node *leaving = new_jump_unless(&m, it.condition, IR_BREAK);
    it.block->children[0] = leaving;
    it.condition->parent = leaving->children[0];
    for (unsigned i = 0; i < it.block->child_count; i++)
        it.block->children[i]->parent = it.block;
    new_node_adopt(loop, header_of(loop),
                   loop->kind == IR_FOR ? new_node_of(&m, IR_EMPTY, NULL, 0) : new_truth(&m));
    new_node_adopt(loop, body_of(loop), it.block);
    loop->flags |= IR_OPENED;
    VECTOR_PUSH(a, &moved->items, it);
}

static void move_below(inner_conditions *moved, arena *a, const source *text, ir_function *function,
                       ir_node *node) {
    for (unsigned i = 0; i < node->child_count; i++) {
        move_below(moved, a, text, function, node->children[i]);
        if (may_move(node->children[i]))
            move(moved, a, text, function, node->children[i]);
    }
}

inner_conditions *inner_conditions_move(arena *a, const source *text, ir_function *function,
                                        ir_node *loop) {
    inner_conditions *moved = ARENA_NEW(a, inner_conditions);
    move_below(moved, a, text, function, (ir_node *)ir_loop_body(loop));
    if (may_move((ir_node *)ir_loop_body(loop))) /* a body without braces */
        move(moved, a, text, function, (ir_node *)ir_loop_body(loop));
    return moved->items.count ? moved : NULL;
}

void inner_conditions_put_back(const inner_conditions *moved) {
    for (unsigned n = moved->items.count; n-- > 0;) {
        const moved_condition *it = &moved->items.items[n];
        ir_node *body = it->body;
        new_node_adopt(it->loop, header_of(it->loop), it->header);
        new_node_adopt(it->loop, body_of(it->loop), body);
        it->condition->parent = it->header == it->condition ? it->loop : it->header;
        for (unsigned i = 0; body->kind == IR_BLOCK && i < body->child_count; i++)
            body->children[i]->parent = body;
        it->loop->flags &= ~(unsigned)IR_OPENED;
    }
}
