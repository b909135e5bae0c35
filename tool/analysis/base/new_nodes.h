/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Makes nodes that have no text of their own, for loops whose headers are brought into another
 *  form. */
#ifndef ANALYSIS_NEW_NODES_H
#define ANALYSIS_NEW_NODES_H

#include "ir/ir.h"
#include "support/source.h"

typedef struct node_maker {
    arena *memory;
    ir_function *function;
    ir_range range; /* empty */
} node_maker;

node_maker new_nodes_at(arena *a, ir_function *function, uint32_t offset);

ir_node *new_node_of(const node_maker *m, ir_kind kind, const ir_type *type, unsigned children);
void new_node_adopt(ir_node *parent, unsigned number, ir_node *child);

/** !condition. The condition keeps its parent. */
ir_node *new_negation(const node_maker *m, ir_node *condition);

/** The number 1. */
ir_node *new_truth(const node_maker *m);

/** A block with the statements of a loop's body, after `room` children that the caller sets. The
 *  statements keep their parents. The block's range is that of the body and its `;`. */
ir_node *new_block_around(const node_maker *m, const source *text, ir_node *body, unsigned room);

/** The expression of a part of a loop's header. */
const ir_node *new_nodes_expression(const ir_node *part);

#endif
