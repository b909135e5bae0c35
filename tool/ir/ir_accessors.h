/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Accessors: functions that only compute an address:
 *
 *     static double *slot(struct table *t, int k) { return &t->value[k]; }
 *
 * For the analysis, *slot(t, k) is t->value[k]. So is *(t->value + k), with or without a function:
 * a sum of a pointer and integers that is dereferenced is a subscript.
 */
#ifndef IR_ACCESSORS_H
#define IR_ACCESSORS_H

#include "ir/ir.h"

/** Replaces each call of such a function by the address that it computes, in all functions of a
 *  unit that are not finished yet (ir_finish_function). The linkage of the accessor must be known,
 *  and no other definition may replace it. Its body is one return of an expression without side
 *  effects; the arguments have none either. It is defined before the caller, and no variable of the
 *  caller hides a file-scope name in the expression. The new nodes have the range of the call,
 *  whose bytes cannot be edited in parts: IR_FROM_MACRO. Then writes *(p + k) as p[k], and (p +
 * k)->m as p[k].m: *(p + i - k) is p[(long)i - k], and *a of an array is a[0]. */
void ir_look_through_accessors(ir_unit *unit);

/** The last step for one node: writes *(p + k), (p + k)->m and *a so. If its operand replaces
 *  another expression (`is_replaced`), also writes *&x as x, and (&x)->m as x.m. */
void ir_simplify_access(arena *memory, ir_node *node, bool is_replaced);

#endif
