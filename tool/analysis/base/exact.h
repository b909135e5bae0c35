/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The mathematical value of an affine expression, and C's. C computes `t - 1` of an unsigned t
 * modulo 2^32; if t is 0, the mathematical value is -1. They are equal if the type can represent
 * the mathematical value. A mathematical value that is affine in the counter lies between those of
 * the first and the last iteration. Below, *settled* means: shown to be equal.
 */
#ifndef ANALYSIS_EXACT_H
#define ANALYSIS_EXACT_H

#include "ir/ir.h"

/** Is this an integer operation whose result equals the mathematical value modulo 2^w, w the width
 * of its type: + - *, signs, conversions between integers? */
bool exact_is_operation(const ir_node *node);

/** Does C's value of the expression (affine in `counter`) equal the mathematical value in each
 *  iteration that computes it, or equal it modulo 2^64, which suffices for addresses? Otherwise it
 *  may have wrapped around. */
bool exact_is_settled(const ir_node *node, const ir_variable *counter);

/** Does the operation `node` need C's value of its operand, because it is made in a wider type?
 *  Then the operand must be settled. */
bool exact_needs_settled(const ir_node *node, const ir_node *operand);

/** Must both ends be checked before a subscript may be assumed to be monotonic? */
bool exact_may_wrap(const ir_node *subscript, const ir_variable *counter);

/** May a subtraction or negation with the counter make the subscript's mathematical value negative
 *  near the loop's beginning? */
bool exact_may_fall_below(const ir_node *subscript, const ir_variable *counter);

#endif
