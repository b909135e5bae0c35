/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Accessors are functions that only compute an address:
 *
 *      static double *slot(struct table *t, int k) { return &t->value[k]; }
 *
 *  For the analysis, *slot(t, k) is t->value[k]. Likewise *(t->value + k) is t->value[k], whether
 *  or not a function computes the address. */
#ifndef IR_ACCESSORS_H
#define IR_ACCESSORS_H

#include "ir/ir.h"

/** Replaces each call of an accessor by the address that it computes, in all functions of the unit.
 *  Call it before ir_finish_function, when the accessors' linkage is known.
 *
 *  The accessor's body must be one return of an expression. Neither it nor the arguments may have
 *  side effects. No other definition may replace the accessor, and it must be defined before the
 *  caller. No variable of the caller may hide a file-scope name in the expression. The new nodes
 *  have the range of the call and are IR_FROM_MACRO.
 *
 *  It then writes *(p + k) as p[k], (p + k)->m as p[k].m, *(p + i - k) as p[(long)i - k], and *a of
 *  an array a as a[0]. */
void ir_look_through_accessors(ir_unit *unit);

/** Rewrites one node *(p + k), (p + k)->m or *a in this way. If its operand replaces another
 *  expression (`is_replaced`), also writes *&x as x, and (&x)->m as x.m. */
void ir_simplify_access(arena *memory, ir_node *node, bool is_replaced);

#endif
