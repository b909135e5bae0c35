/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Decides whether the base of an array or source (facts.h) may be evaluated before the loop. */
#ifndef ANALYSIS_BASES_H
#define ANALYSIS_BASES_H

#include "analysis/loop/loop_analysis.h"

/** May the invariant `base` be evaluated before the loop? True if that reads no memory, or if each
 *  iteration or the loop's bound dereferences the same pointer anyway, so that it cannot be null.
 *  If the base is itself an element of an array, the loop must read this same element anyway. */
bool base_can_be_read_before(const loop_analysis *j, const ir_node *base);

/** Does each iteration dereference the pointer through which `load` reads a member? Then the load
 *  is valid even if the program does not make it. False if subscripts occur in `load`. */
bool base_is_in_object_read(const loop_analysis *j, const ir_node *load);

#endif
