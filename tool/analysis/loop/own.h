/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Elements of an iteration's own, which it reads and stores to:
 *
 *     if (member[t] != c) changes++;
 *     member[t] = c;
 *
 * No other iteration touches the element. While the loop runs a variable stands for it, and memory
 * stays as it was before the loop: however often an iteration is executed, it begins with the same
 * value. What the variable is in the end is kept, as operands of scalars are, and stored once all
 * iterations are over.
 */
#ifndef ANALYSIS_OWN_H
#define ANALYSIS_OWN_H

#include "analysis/loop/loop_analysis.h"

/** Is it a scalar t[i + c] or a part of one, that lies elsewhere in each iteration: of an array
 * that is a variable, or behind a pointer that stays? */
bool own_is_element(const loop_analysis *j, const ir_node *lvalue);

/** Where analyser.keeps_own: notes the elements to which variables are given, and classes their
 *  accesses. One is added for each, of what is read first. */
void own_take(loop_analysis *j);

/** When all writes have their classes: does nothing but updates write where an own element may be?
 *  Sets the reason, and returns false. */
bool own_check(loop_analysis *j);

/** The number of the own element that this node names; -1: it names none. */
int own_named(const loop_analysis *j, const ir_node *node);

#endif
