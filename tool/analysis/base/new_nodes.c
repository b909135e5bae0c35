/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/new_nodes.h"

#include "ir/ir_syntax.h"

node_maker new_nodes_for(arena *a, ir_function *function, const ir_node *header,
                         const ir_node *body) {
    return (node_maker){a, function, header->id, {body->range.begin, body->range.begin}};
}

ir_node *new_node_of(const node_maker *m, ir_kind kind, const ir_type *type, unsigned children) {
    ir_node *node = ir_new(m->memory, kind, type, children);
    node->id = m->id;
    node->range = m->range;
    return node;
}

void new_node_adopt(ir_node *parent, unsigned number, ir_node *child) {
    parent->children[number] = child;
    child->parent = parent;
}

static unsigned last_id(const ir_node *node) {
    while (node->child_count)
        node = node->children[node->child_count - 1];
    return node->id;
}

ir_node *new_jump_unless(const node_maker *m, ir_node *condition, ir_kind jump) {
    ir_node *statement = new_node_of(m, IR_IF, NULL, 2);
    ir_node *negation = new_node_of(m, IR_UNARY, condition->type, 1);
    negation->op = IR_OP_NOT;
    negation->children[0] = condition;
    new_node_adopt(statement, 0, negation);
    new_node_adopt(statement, 1, new_node_of(m, jump, NULL, 0));
    statement->children[1]->id = last_id(condition); /* the jump comes after the condition */
    return statement;
}

ir_node *new_truth(const node_maker *m) {
    static const ir_type truth = {.kind = IR_INTEGER, .size = 4, .is_signed = true};
    ir_node *number = new_node_of(m, IR_NUMBER, &truth, 0);
    number->text = "1";
    number->flags = IR_HAS_VALUE;
    number->value = 1;
    return number;
}

ir_node *new_block_around(const node_maker *m, const source *text, ir_node *body, unsigned room) {
    const bool is_block = body->kind == IR_BLOCK;
    ir_node *block = new_node_of(m, IR_BLOCK, NULL, room + (is_block ? body->child_count : 1));
    block->id = m->function->node_count++;
    block->range = (ir_range){body->range.begin, syntax_statement_end(text, body)};
    for (unsigned i = room; i < block->child_count; i++)
        block->children[i] = is_block ? body->children[i - room] : body;
    return block;
}

const ir_node *new_nodes_expression(const ir_node *part) {
    return part->kind == IR_EXPRESSION ? part->children[0] : part;
}
