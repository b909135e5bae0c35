/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Queries on trees and their text: equality of expressions, the end of a statement, and which
 *  bytes of a statement can be edited. */
#ifndef IR_SYNTAX_H
#define IR_SYNTAX_H

#include "ir/ir.h"

/** Are the two expressions equal? `(*s).b` and `s->b` are equal. Expressions with calls,
 *  assignments or opaque parts never are. Equal expressions denote the same memory only if none of
 *  their operands changes in between. */
bool syntax_same(const ir_node *left, const ir_node *right);

/** The offset of the byte after the statement, including its `;` if the text has one. */
uint32_t syntax_statement_end(const source *text, const ir_node *statement);

/** The nearest statement, within `outer`, that contains the node or is the node itself. For a
 *  declarator's initialiser it is the declaration. */
const ir_node *syntax_enclosing_statement(const ir_node *node, const ir_node *outer);

/** The outermost statement within `outer` that begins at the same byte as `statement`. It differs
 *  from `statement` only if one macro call expands to both, or both are parts of one IR_SEQUENCE.
 *  NULL if it shares text with an adjacent statement, because then it cannot be edited separately.
 *  Also NULL if `statement` has no text of its own. */
const ir_node *syntax_editable_statement(const ir_node *statement, const ir_node *outer);

#endif
