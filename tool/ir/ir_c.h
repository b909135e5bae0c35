/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Prints IR as C text, for slices, guards and other generated code. */
#ifndef IR_IR_C_H
#define IR_IR_C_H

#include "ir/ir.h"
#include "support/buffer.h"

/** Replaces the text of a node, for instance of an array that has been copied. Returns the C text
 *  of a primary expression, or NULL to keep the node's own text. */
typedef const char *(*ir_c_rename)(const ir_node *node, void *context);

/** Returns the C text of a type for a cast or compound literal, or NULL if it has none. */
typedef const char *(*ir_c_spell)(const ir_type *type, void *context);

/** Same as ir_c_expression, but `spell` spells the types. If `spell` is NULL, each type's own
 *  spelling is used. */
bool ir_c_expression_spelled(buffer *out, const ir_node *expression, ir_c_rename rename,
                             ir_c_spell spell, void *context);

/** Appends the expression as C text, with the parentheses it needs. It may also be a declaration's
 *  initialiser in braces. Returns false, and appends nothing, if C cannot express it (opaque nodes,
 *  types without a name). */
bool ir_c_expression(buffer *out, const ir_node *expression, ir_c_rename rename, void *context);

#endif
