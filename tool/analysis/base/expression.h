/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Queries on single expressions that need only the tree. */
#ifndef ANALYSIS_EXPRESSION_H
#define ANALYSIS_EXPRESSION_H

#include "ir/ir.h"

/** Are the trees equal: the same variables, fields, operators and constants in the same places? *p
 *  equals p[0]. Whether their values are equal, the caller must decide. An opaque node, or a sizeof
 *  without a value, equals only itself. */
bool expression_same(const ir_node *a, const ir_node *b);

/** The number of occurrences of the tree `part` in `node`; 1 if they are equal. */
unsigned expression_occurrences(const ir_node *node, const ir_node *part);

/** Is it an integer constant? Stores its value in *value. */
bool expression_constant(const ir_node *node, int64_t *value);

/** Is it the variable itself? */
static inline bool expression_is_variable(const ir_node *node, const ir_variable *variable) {
    return node->kind == IR_VARIABLE && node->variable == variable;
}

bool expression_mentions(const ir_node *node, const ir_variable *variable);

/** Does it contain no assignment, increment, call or opaque node? */
bool expression_is_plain(const ir_node *node);

/** Does its evaluation read memory through a pointer or a subscript, or call a function? Reading a
 *  plain variable does not count. If as_address is set, the question is about evaluating
 *  &expression. */
bool expression_has_load(const ir_node *node, bool as_address);

/** Is it an lvalue (a[i], *p, s->x, s.x, v)? False for a cast of one. */
bool expression_is_lvalue(const ir_node *node);

/** Is it a scalar lvalue other than a variable? */
bool expression_is_scalar_access(const ir_node *node);

/** The variable v of an lvalue v, v.f or v[1].f; NULL if the lvalue is reached through a
 *  pointer. */
ir_variable *expression_object(const ir_node *lvalue);

/** The expression's C text, for messages and names; "..." if C cannot express it. In the arena. */
const char *expression_text(arena *a, const ir_node *node);

/** The statement or declarator around an expression. A line of text can be inserted before it. */
const ir_node *expression_place(const ir_node *node);

/** Is the node itself arithmetic on floating or complex values? Signs, comparisons, casts and loads
 *  do not count. */
bool expression_is_floating_work(const ir_node *node);

/** The lvalue that an assignment, increment or decrement writes; NULL for other nodes, including
 *  declarators. */
const ir_node *expression_written(const ir_node *node);

/** May evaluating this node itself trap or be undefined for some operands? True for calls,
 *  divisions and shifts, floating operations and conversions, compound assignments, and differences
 *  of pointers. Signed sums and products may overflow too, but outside of assignments they are
 *  generated in wrapping form (emit/base/wrapping.c). */
bool expression_is_hazard(const ir_node *node);
/** Is the node, or any node below it, a hazard (expression_is_hazard)? Loads do not count. */
bool expression_has_hazard(const ir_node *node);

/** The operator op' with `b op' a` equivalent to `a op b`. It differs from op only for <, <=, > and
 *  >=. */
ir_operator expression_mirrored(ir_operator op);

/** The comparison that, for integers, holds if and only if `op` does not. IR_OP_NONE if `op` is no
 *  comparison. */
ir_operator expression_negated(ir_operator op);

/** Is it a local variable or a parameter, with automatic storage? */
bool variable_is_automatic(const ir_variable *variable);

/** Does executing the node evaluate this child exactly once? False for the right operand of && and
 *  ||, the operand of &, calls, and all parts of control statements but the condition of an `if`.
 */
bool expression_evaluates(const ir_node *node, const ir_node *part);

/** Is the node the target of a plain `=`? Then its old value is not read. */
bool expression_is_assigned(const ir_node *node);

#endif
