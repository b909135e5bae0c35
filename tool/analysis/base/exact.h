/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Compares C's value of an affine expression (a·counter + b) with its mathematical value. C
 *  computes `t - 1` of an unsigned t modulo 2^32; if t is 0, the mathematical value is -1. The two
 *  values are equal if the type can represent the mathematical one. The mathematical value in any
 *  iteration lies between those in the first and the last iteration. An expression is called
 *  *settled* if the two values are shown to be equal. */
#ifndef ANALYSIS_EXACT_H
#define ANALYSIS_EXACT_H

#include "ir/ir.h"

/** Is it an integer operation with a result that equals the mathematical value modulo 2^w, for a
 *  type of w bits? These are + - *, signs, and conversions between integers. */
bool exact_is_operation(const ir_node *node);

/** Is the expression, affine in `counter`, settled: does C's value equal the mathematical value in
 *  each iteration that computes it? Equality modulo 2^64 is enough, because it suffices for
 *  addresses. If false, the value may have wrapped around. */
bool exact_is_settled(const ir_node *node, const ir_variable *counter);

/** Must the operand of `node` be settled? It must if the operation has a wider type than its
 *  operand. */
bool exact_needs_settled(const ir_node *node, const ir_node *operand);

/** May the subscript wrap around between the first and the last iteration? Then both ends must be
 *  checked before it may be assumed to be monotonic. */
bool exact_may_wrap(const ir_node *subscript, const ir_variable *counter);

/** Does the subscript subtract or negate a value that depends on the counter? Then its mathematical
 *  value may be negative near the loop's beginning. */
bool exact_may_fall_below(const ir_node *subscript, const ir_variable *counter);

#endif
