/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** IR as C text: for slices, guards and other generated code. */
#ifndef IR_IR_C_H
#define IR_IR_C_H

#include "ir/ir.h"
#include "support/buffer.h"

/** May give another spelling for a node (the copy of an array, for instance): returns the C text of
 *  a primary expression, or NULL for the node's own. */
typedef const char *(*ir_c_rename)(const ir_node *node, void *context);

/** Gives the C text of a type in a cast or compound literal, or NULL if it has none. */
typedef const char *(*ir_c_spell)(const ir_type *type, void *context);

/** As ir_c_expression, with types spelled by `spell` (NULL: by their own spelling). */
bool ir_c_expression_spelled(buffer *out, const ir_node *expression, ir_c_rename rename,
                             ir_c_spell spell, void *context);

/** Appends the expression, or the initialiser of a declaration in braces, as C, with the necessary
 *  parentheses. Returns false, and appends nothing, if it cannot be spelled (opaque nodes, types
 *  without a name). */
bool ir_c_expression(buffer *out, const ir_node *expression, ir_c_rename rename, void *context);

#endif
