/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Queries on trees and their text: equality, the end of a statement, macros. */
#ifndef IR_SYNTAX_H
#define IR_SYNTAX_H

#include "ir/ir.h"

/** Are the two expressions equal? (`(*s).b` and `s->b` are; calls and assignments never.) They
 * denote the same memory only if none of their operands changes in between. */
bool syntax_same(const ir_node *left, const ir_node *right);

/** The offset after a statement's last byte, including its `;` if the text has one. */
uint32_t syntax_statement_end(const source *text, const ir_node *statement);

/** The statement around a node of an expression (itself, if it is a statement), within `outer`; a
 *  declaration for a declarator's initialiser. */
const ir_node *syntax_enclosing_statement(const ir_node *node, const ir_node *outer);

/**
 * The outermost statement within `outer` that begins at the same byte as `statement`; a different
 * one only if one macro call expands to both. NULL if it shares its text with an adjacent
 * statement, so that it cannot be edited separately.
 */
const ir_node *syntax_editable_statement(const ir_node *statement, const ir_node *outer);

#endif
