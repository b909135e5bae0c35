/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Values of affine expressions as numbers. C computes `t - 1` of an unsigned t modulo 2^32; the
 * number is -1 where t is 0. Both agree wherever the number is a value of the type, and a number
 * that is affine in the counter lies between what it is in the first and in the last iteration.
 */
#ifndef ANALYSIS_EXACT_H
#define ANALYSIS_EXACT_H

#include "ir/ir.h"

/** Is this an integer operation whose result in another iteration is the number, modulo 2 to the
 *  size of its type: + - *, their signs, conversions between integers? */
bool exact_is_operation(const ir_node *node);

/** Is C's value of the expression (affine in `counter`) the number itself in each iteration that
 *  computes it, or the number modulo 2^64, as addresses are? Else it may have wrapped around. */
bool exact_is_settled(const ir_node *node, const ir_variable *counter);

/** Does the operation `node` need C's value of its operand, because it is made in a wider type?
 *  Then the number must be shown to be a value of the operand's type. */
bool exact_needs_settled(const ir_node *node, const ir_node *operand);

/** Must anything be checked at both ends before a subscript may be taken to move one way? */
bool exact_may_wrap(const ir_node *subscript, const ir_variable *counter);

/** Does it hold an operation that may leave its type below zero, at the first iterations? */
bool exact_may_fall_below(const ir_node *subscript, const ir_variable *counter);

#endif
