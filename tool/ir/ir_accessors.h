/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Functions that say where something is, and no more:
 *
 *     static double *slot(struct table *t, int k) { return &t->value[k]; }
 *
 * For whoever analyses a call of one, *slot(t, k) is t->value[k].
 */
#ifndef IR_ACCESSORS_H
#define IR_ACCESSORS_H

#include "ir/ir.h"

/** Puts the address that such a function computes in place of each call of it, in all functions of
 *  a unit that are not finished yet (ir_finish_function), and of whose linkage all is known. The
 * function's body is one return of an expression without effects; so are the arguments, no other
 * definition of it may run, it stands before the caller, and the caller has no variables of the
 * names of those of the file that the expression says. The new nodes have the range of the call,
 * whose bytes cannot be edited in parts: IR_FROM_MACRO. */
void ir_look_through_accessors(ir_unit *unit);

#endif
