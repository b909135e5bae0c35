/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Questions about trees and their text: sameness, where a statement ends, macros. */
#ifndef IR_SYNTAX_H
#define IR_SYNTAX_H

#include "ir/ir.h"

/** Do the two expressions say the same? (`(*s).b` and `s->b` do.) They name the same memory only
 *  where nothing in them changes in between. */
bool syntax_same(const ir_node *left, const ir_node *right);

/** The offset after a statement's last byte, its `;` included where the `;` is in the text. */
uint32_t syntax_statement_end(const source *text, const ir_node *statement);

bool syntax_is_statement(const ir_node *node);

/** The statement around a node of an expression (itself, where it is a statement), within `outer`;
 *  a declaration for a declarator's initialiser. */
const ir_node *syntax_enclosing_statement(const ir_node *node, const ir_node *outer);

/**
 * The outermost statement within `outer` that begins at the very byte where `statement` begins:
 * another than itself only where one macro call stands for both. NULL where its text is also that
 * of a statement beside it, so that it cannot be edited by itself.
 */
const ir_node *syntax_editable_statement(const ir_node *statement, const ir_node *outer);

#endif
