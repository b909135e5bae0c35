/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Makes nodes that have no text of their own, for loops whose headers are brought into another
 *  form. */
#ifndef ANALYSIS_NEW_NODES_H
#define ANALYSIS_NEW_NODES_H

#include "ir/ir.h"
#include "support/source.h"

/** Analyses compare ids to learn which node comes first. So the new nodes have the id of the
 *  header's part from which they are made, which comes before the loop's body. A jump, which comes
 *  after its condition, has the id of the condition's last node. A block has an id of its own: of
 *  statements that share an id, only one would be kept in a slice. */
typedef struct node_maker {
    arena *memory;
    ir_function *function;
    unsigned id;
    ir_range range; /* empty */
} node_maker;

/** Returns a maker of nodes for a loop of the function, with this part of its header, and this
 * body. Makes no node yet. */
node_maker new_nodes_for(arena *a, ir_function *function, const ir_node *header,
                         const ir_node *body);

ir_node *new_node_of(const node_maker *m, ir_kind kind, const ir_type *type, unsigned children);
void new_node_adopt(ir_node *parent, unsigned number, ir_node *child);

/** if (!condition) jump; The condition keeps its parent. */
ir_node *new_jump_unless(const node_maker *m, ir_node *condition, ir_kind jump);

/** The number 1. */
ir_node *new_truth(const node_maker *m);

/** A block with the statements of a loop's body, after `room` children that the caller sets. The
 *  statements keep their parents. The block's range is that of the body and its `;`. */
ir_node *new_block_around(const node_maker *m, const source *text, ir_node *body, unsigned room);

/** Returns the expression of a part of a loop's header: the part itself, or its child if it is an
 *  IR_EXPRESSION. */
const ir_node *new_nodes_expression(const ir_node *part);

#endif
