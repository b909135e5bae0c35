/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Elements of an iteration's own, which it reads and stores to:
 *
 *     if (member[t] != c) changes++;
 *     member[t] = c;
 *
 * No other iteration touches the element. While the loop runs, a variable replaces the element, and
 * memory is unchanged: even if an iteration is executed several times, it begins with the same
 * value. The variable's last value is kept, as operands of scalars are, and stored after all
 * iterations.
 */
#ifndef ANALYSIS_OWN_H
#define ANALYSIS_OWN_H

#include "analysis/loop/loop_analysis.h"

/** Is it a scalar t[i + c] or a part of one, at a different address in each iteration? Its array
 *  must be a variable, or the target of an invariant pointer. */
bool own_is_element(const loop_analysis *j, const ir_node *lvalue);

/** If analyser.keeps_own is set: lists the elements that variables replace, and classifies their
 *  accesses. Adds an access for each element: the read at the beginning. */
void own_take(loop_analysis *j);

/** Once all writes are classified: do only updates write memory that may be an own element? If not,
 *  sets the reason. */
bool own_check(loop_analysis *j);

/** The number of the own element that this node names; -1: it names none. */
int own_named(const loop_analysis *j, const ir_node *node);

#endif
