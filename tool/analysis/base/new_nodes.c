/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/new_nodes.h"

#include "ir/ir_syntax.h"

node_maker new_nodes_at(arena *a, ir_function *function, uint32_t offset) {
    return (node_maker){a, function, {offset, offset}};
}

ir_node *new_node_of(const node_maker *m, ir_kind kind, const ir_type *type, unsigned children) {
    ir_node *node = ir_new(m->memory, kind, type, children);
    node->id = m->function->node_count++;
    node->range = m->range;
    return node;
}

void new_node_adopt(ir_node *parent, unsigned number, ir_node *child) {
    parent->children[number] = child;
    child->parent = parent;
}

ir_node *new_negation(const node_maker *m, ir_node *condition) {
    ir_node *negation = new_node_of(m, IR_UNARY, condition->type, 1);
    negation->op = IR_OP_NOT;
    negation->children[0] = condition;
    return negation;
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
    block->range = (ir_range){body->range.begin, syntax_statement_end(text, body)};
    for (unsigned i = room; i < block->child_count; i++)
        block->children[i] = is_block ? body->children[i - room] : body;
    return block;
}

const ir_node *new_nodes_expression(const ir_node *part) {
    return part->kind == IR_EXPRESSION ? part->children[0] : part;
}
