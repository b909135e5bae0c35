/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Questions about single expressions, answered from the tree alone. */
#ifndef ANALYSIS_EXPRESSION_H
#define ANALYSIS_EXPRESSION_H

#include "ir/ir.h"

/** The same tree: the same variables, fields, operators and constants in the same places. That
 *  they have the same value is the caller's to know. Opaque nodes equal nothing. */
bool expression_same(const ir_node *a, const ir_node *b);

/** How often the same tree as `part` stands in `node`, itself included. */
unsigned expression_occurrences(const ir_node *node, const ir_node *part);

/** Is it the integer constant *value? */
bool expression_constant(const ir_node *node, int64_t *value);

/** Is it the variable itself? */
static inline bool expression_is_variable(const ir_node *node, const ir_variable *variable) {
    return node->kind == IR_VARIABLE && node->variable == variable;
}

bool expression_mentions(const ir_node *node, const ir_variable *variable);

/** No assignment, increment, call or opaque node in it. */
bool expression_is_plain(const ir_node *node);

/** Does evaluating it as a value, or (as_address) as &expression, read memory through a pointer or
 *  a subscript? Plain variables do not count. */
bool expression_has_load(const ir_node *node, bool as_address);

/** Is it an lvalue of memory (a[i], *p, s->x, s.x, v), casts not counted? */
bool expression_is_lvalue(const ir_node *node);

/** The variable in whose own storage the lvalue lies: of v, v.f, v[1].f, but not behind a pointer;
 *  or NULL. */
ir_variable *expression_object(const ir_node *lvalue);

/** Its text as C, for messages and names; "..." where it cannot be spelled. In the arena. */
const char *expression_text(arena *a, const ir_node *node);

/** The statement or declarator around an expression: that before which a line of text may be put.
 */
const ir_node *expression_place(const ir_node *node);

/** Arithmetic on floating or complex values at this very node (not below; comparisons, casts and
 *  loads are none). */
bool expression_is_floating_work(const ir_node *node);

/** What an assignment, increment, decrement or declarator writes: its target lvalue as a node, or
 *  NULL. For declarators, and where nothing is written, NULL. */
const ir_node *expression_written(const ir_node *node);

/** May evaluating this very node (not what is below) trap, or have no meaning, for some operands:
 * calls, divisions, shifts, conversions of floating values, assignments with an operator? Sums and
 *  products of signed integers may too: they are written so that they wrap around
 *  (emit/base/wrapping.c), but for those that assign. */
bool expression_is_hazard(const ir_node *node);
/** The same of it and all that is below. Loads do not count. */
bool expression_has_hazard(const ir_node *node);

/** The operator of `b op a` that says what `a op b` says; the same one but for orderings. */
ir_operator expression_mirrored(ir_operator op);

/** Is it a local or parameter with automatic storage? */
bool variable_is_automatic(const ir_variable *variable);

#endif
