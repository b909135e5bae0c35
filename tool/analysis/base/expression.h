/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Queries on single expressions that need only the tree. */
#ifndef ANALYSIS_EXPRESSION_H
#define ANALYSIS_EXPRESSION_H

#include "ir/ir.h"

/** Equal trees: the same variables, fields, operators and constants in the same places; *p equals
 *  p[0]. The caller must know whether their values are equal. An opaque node, or a sizeof without a
 *  value, equals only itself. */
bool expression_same(const ir_node *a, const ir_node *b);

/** The number of occurrences of the tree `part` in `node`, including itself. */
unsigned expression_occurrences(const ir_node *node, const ir_node *part);

/** Is it the integer constant *value? */
bool expression_constant(const ir_node *node, int64_t *value);

/** Is it the variable itself? */
static inline bool expression_is_variable(const ir_node *node, const ir_variable *variable) {
    return node->kind == IR_VARIABLE && node->variable == variable;
}

bool expression_mentions(const ir_node *node, const ir_variable *variable);

/** Does it contain no assignment, increment, call or opaque node? */
bool expression_is_plain(const ir_node *node);

/** Does evaluating it as a value, or (as_address) as &expression, read memory through a pointer or
 *  a subscript, or call a function? Plain variables do not count. */
bool expression_has_load(const ir_node *node, bool as_address);

/** Is it an lvalue of memory (a[i], *p, s->x, s.x, v), casts not counted? */
bool expression_is_lvalue(const ir_node *node);

/** Is it an lvalue of memory and of scalar type, but no variable? */
bool expression_is_scalar_access(const ir_node *node);

/** The variable that contains the lvalue: of v, v.f, v[1].f, but not behind a pointer; or NULL. */
ir_variable *expression_object(const ir_node *lvalue);

/** Its text as C, for messages and names; "..." if it cannot be spelled. In the arena. */
const char *expression_text(arena *a, const ir_node *node);

/** The statement or declarator around an expression, before which a line of text can be
 *  inserted. */
const ir_node *expression_place(const ir_node *node);

/** Is this node itself arithmetic on floating or complex values (excluding signs, comparisons,
 * casts and loads)? */
bool expression_is_floating_work(const ir_node *node);

/** The target lvalue of an assignment, increment or decrement; NULL for declarators and nodes that
 *  write nothing. */
const ir_node *expression_written(const ir_node *node);

/** May evaluating this node itself trap or be undefined for some operands: calls, divisions and
 *  shifts, floating operations and conversions, compound assignments, differences of pointers?
 *  Signed sums and products may overflow, too, but except in assignments they are generated in
 *  wrapping form (emit/base/wrapping.c). */
bool expression_is_hazard(const ir_node *node);
/** The same for the node and everything below it. Loads do not count. */
bool expression_has_hazard(const ir_node *node);

/** The operator of `b op a` that is equivalent to `a op b`; differs only for orderings. */
ir_operator expression_mirrored(ir_operator op);

/** The comparison of integers that holds if and only if this one does not; IR_OP_NONE: `op` is no
 *  comparison. */
ir_operator expression_negated(ir_operator op);

/** Is it a local or parameter with automatic storage? */
bool variable_is_automatic(const ir_variable *variable);

/** Does evaluating the node evaluate each of its parts once? False for &&, || and &, for calls and
 *  control statements. */
bool expression_evaluates_parts(const ir_node *node);

/** Is the node the target of a plain `=`? Then its value is not read there. */
bool expression_is_assigned(const ir_node *node);

#endif
