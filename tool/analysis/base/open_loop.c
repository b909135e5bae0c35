/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/open_loop.h"

#include <stdint.h>

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "analysis/base/loop_exits.h"
#include "analysis/base/new_nodes.h"
#include "analysis/base/step_inside.h"

/* ---- the counter ----------------------------------------------------------------------------- */

static bool may_count(const ir_variable *variable) {
    const ir_type *type = variable->type, *target = type->target;
    return variable_is_automatic(variable) && !variable->address_taken &&
           (type->kind == IR_POINTER ? target && target->size > 0 && type->spelling
                                     : ir_type_is_plain_integer(type) && type->size >= 4);
}

/* The first variable that a part of the increment steps upwards. */
static ir_variable *stepped_up(const ir_node *increment) {
    ir_variable *variable;
    int64_t step;
    if (increment->kind == IR_BINARY && increment->op == IR_OP_COMMA) {
        ir_variable *first = stepped_up(increment->children[0]);
        return first ? first : stepped_up(increment->children[1]);
    }
    return counted_step(increment, &variable, &step) && step > 0 && may_count(variable) ? variable
                                                                                        : NULL;
}

/* The first variable that an expression in the node steps upwards after its use, as in *p++. Inner
 * loops are not searched. */
static ir_variable *stepped_inside(const ir_node *node) {
    ir_variable *variable = is_step_afterwards(node) ? stepped_up(node) : NULL;
    for (unsigned i = 0; i < node->child_count && !variable && !ir_is_loop(node); i++)
        variable = stepped_inside(node->children[i]);
    return variable;
}

/* The variable that a step of its own steps: in the third clause, or at the end of the body. */
static ir_variable *stepped_at_end(const ir_node *loop) {
    if (loop->kind == IR_FOR)
        return stepped_up(new_nodes_expression(loop->children[2]));
    const ir_node *body = ir_loop_body(loop), *last = body;
    if (body->kind == IR_BLOCK)
        last = body->child_count ? body->children[body->child_count - 1] : NULL;
    return last && last->kind == IR_EXPRESSION ? stepped_up(last->children[0]) : NULL;
}

/* The variable that the loop steps. Whether it counts the iterations is decided by
 * counted_recognise_analysed. */
static ir_variable *counter_of(const ir_node *loop, const ir_node *condition) {
    ir_variable *variable = stepped_at_end(loop);
    if (!variable)
        variable = stepped_inside(condition);
    return variable ? variable : stepped_inside(ir_loop_body(loop));
}

/* ---- new nodes ------------------------------------------------------------------------------- */

/* The limit: the greatest value of the counter's type, at most 2^60. No pointer reaches this. It
 * does not count as a constant, because the counter need not take all values below it. */
static ir_node *limit_of(const node_maker *m, const ir_type *type) {
    ir_node *number = new_node_of(m, IR_NUMBER, type, 0);
    const bool is_wide = type->kind == IR_POINTER || type->size == 8;
    number->text = is_wide ? "1152921504606846976" : type->is_signed ? "2147483647" : "4294967295u";
    if (type->kind != IR_POINTER)
        return number;
    ir_node *address = new_node_of(m, IR_CAST, type, 1);
    new_node_adopt(address, 0, number);
    return address;
}

static ir_node *comparison_of(const node_maker *m, ir_variable *counter, const ir_type *type) {
    ir_node *compared = new_node_of(m, IR_BINARY, type, 2),
            *name = new_node_of(m, IR_VARIABLE, counter->type, 0);
    compared->op = IR_OP_LESS;
    name->variable = counter;
    new_node_adopt(compared, 0, name);
    new_node_adopt(compared, 1, limit_of(m, counter->type));
    return compared;
}

/* `if (!condition) continue;` as an exit. The empty statement stands for its text, which is in the
 * header. */
static void add_exit(const node_maker *m, loop_exits *exits, open_loop *open, ir_node *block) {
    ir_node *rest = new_jump_unless(m, open->condition, IR_CONTINUE);
    ir_node *statement = new_node_of(m, IR_EMPTY, NULL, 0);
    open->negation = rest->children[0];
    rest->children[1]->flags = IR_LEAVES;
    rest->parent = block;
    new_node_adopt(block, 0, statement);
    for (unsigned i = exits->count++; i > 0; i--)
        exits->items[i] = exits->items[i - 1];
    exits->items[0] = (loop_exit){.statement = statement,
                                  .rest = rest,
                                  .condition = open->negation,
                                  .tested = open->negation,
                                  .holder = rest,
                                  .parent = block,
                                  .is_kept = !expression_is_plain(open->condition)};
}

/* ---- the loop -------------------------------------------------------------------------------- */

static bool is_beyond_search(const ir_node *node) {
    return node->kind == IR_CALL || loop_exits_cannot_evaluate(node);
}

loop_exits *open_loop_find(arena *a, const source *text, ir_function *function, ir_node *loop) {
    ir_node *body = (ir_node *)ir_loop_body(loop);
    if (loop->kind != IR_FOR && loop->kind != IR_WHILE)
        return NULL;
    ir_node **place = &loop->children[loop->kind == IR_FOR ? 1 : 0];
    const bool has_exit = (*place)->kind != IR_EMPTY;
    ir_variable *counter = counter_of(loop, *place);
    loop_exits *exits = counter ? loop_exits_find(a, body) : NULL;
    if (!exits || exits->count + has_exit > LOOP_MOST_EXITS || exits->count + has_exit == 0)
        return NULL;
    open_loop *open = ARENA_NEW(a, open_loop);
    *open = (open_loop){.loop = loop, .place = place, .header = *place, .body = body};
    open->condition = has_exit ? (ir_node *)new_nodes_expression(*place) : NULL;
    if (has_exit && ir_any(open->condition, is_beyond_search))
        return NULL;
    const node_maker m = new_nodes_for(a, function, *place, body);
    open->block = new_block_around(&m, text, body, has_exit ? 1 : 0);
    open->block->parent = loop;
    if (has_exit)
        add_exit(&m, exits, open, open->block);
    for (unsigned i = 0; i < exits->count; i++)
        if (exits->items[i].parent == body)
            exits->items[i].parent = exits->items[i].rest->parent = open->block;
    static const ir_type truth = {.kind = IR_INTEGER, .size = 4, .is_signed = true};
    open->limited = comparison_of(&m, counter, has_exit ? open->condition->type : &truth);
    open->limited->parent = loop;
    exits->open = open;
    return exits;
}

static void set_body(const open_loop *open, ir_node *body) {
    open->loop->children[open->loop->kind == IR_FOR ? 3 : 1] = body;
}

void open_loop_limit(const open_loop *open) {
    if (!open)
        return;
    *open->place = open->limited;
    set_body(open, open->block);
    for (unsigned i = 0; i < open->block->child_count; i++)
        open->block->children[i]->parent = open->block;
    if (open->condition)
        open->condition->parent = open->negation;
}

void open_loop_restore(const open_loop *open) {
    if (!open)
        return;
    *open->place = open->header;
    set_body(open, open->body);
    for (unsigned i = open->condition ? 1 : 0; i < open->block->child_count; i++)
        open->block->children[i]->parent = open->body->kind == IR_BLOCK ? open->body : open->loop;
    if (open->condition)
        open->condition->parent = open->header == open->condition ? open->loop : open->header;
}
