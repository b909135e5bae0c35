/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Values of affine expressions as numbers. C computes `t - 1` of an unsigned t modulo 2^32; the
 * number is -1 if t is 0. Both agree if the number is a value of the type. A number that is affine
 * in the counter lies between its values in the first and the last iteration.
 */
#ifndef ANALYSIS_EXACT_H
#define ANALYSIS_EXACT_H

#include "ir/ir.h"

/** Is this an integer operation whose result in each iteration is the number, modulo 2 to the size
 *  of its type: + - *, signs, conversions between integers? */
bool exact_is_operation(const ir_node *node);

/** Is C's value of the expression (affine in `counter`) the number itself in each iteration that
 *  computes it, or the number modulo 2^64, as addresses are? Otherwise it may have wrapped
 *  around. */
bool exact_is_settled(const ir_node *node, const ir_variable *counter);

/** Does the operation `node` need C's value of its operand, because it is made in a wider type?
 *  Then the number must be shown to be a value of the operand's type. */
bool exact_needs_settled(const ir_node *node, const ir_node *operand);

/** Must both ends be checked before a subscript may be assumed to be monotonic? */
bool exact_may_wrap(const ir_node *subscript, const ir_variable *counter);

/** Does it contain an operation that may fall below zero in the first iterations? */
bool exact_may_fall_below(const ir_node *subscript, const ir_variable *counter);

#endif
