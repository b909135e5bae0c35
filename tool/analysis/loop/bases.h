/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Decides whether the base of an array or source (facts.h) may be evaluated before the loop. */
#ifndef ANALYSIS_BASES_H
#define ANALYSIS_BASES_H

#include "analysis/loop/loop_analysis.h"

/** May the invariant `base` be evaluated before the loop? True if that dereferences no pointer, or
 *  a pointer that each iteration or the loop's bound dereferences anyway, so that it cannot be
 *  null. If subscripts occur in the base, and it is not an array itself, the loop must read exactly
 *  this lvalue anyway. */
bool base_can_be_read_before(const loop_analysis *j, const ir_node *base);

/** Does each iteration, or the loop's bound, dereference the pointer through which `load` reads?
 *  Then the load is valid even where the program does not make it. False if subscripts occur in
 *  `load`. */
bool base_is_in_object_read(const loop_analysis *j, const ir_node *load);

#endif
