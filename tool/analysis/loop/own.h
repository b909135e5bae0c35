/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds own elements: array elements that one iteration stores to and no other iteration touches:
 *
 *      if (member[t] != c) changes++;
 *      member[t] = c;
 *
 *  While the loop runs, a variable replaces the element, and the element itself is not written.
 *  Even if an iteration is executed several times, it therefore begins with the same value. The
 *  variable's last value is kept, like the operands of scalars, and stored after all iterations. */
#ifndef ANALYSIS_OWN_H
#define ANALYSIS_OWN_H

#include "analysis/loop/loop_analysis.h"

/** Is the lvalue t[i + c], or a part of it, at a different address in each iteration? The array
 *  must be a variable, or the target of an invariant pointer. */
bool own_is_element(const loop_analysis *j, const ir_node *lvalue);

/** Lists the elements that variables will replace, and classifies the accesses to them. For each
 *  element, adds an access that represents the read at the iteration's beginning. Does nothing
 *  unless analyser.keeps_own is set. */
void own_take(loop_analysis *j);

/** Checks, once all writes are classified, that nothing but an update may write memory that may be
 *  an own element. If not, sets the reason and returns false. */
bool own_check(loop_analysis *j);

/** Index of the own element that this node names; -1 if it names none. */
int own_named(const loop_analysis *j, const ir_node *node);

#endif
