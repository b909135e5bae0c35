/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Decides whether the base of an array or source may be evaluated before the loop. */
#ifndef ANALYSIS_BASES_H
#define ANALYSIS_BASES_H

#include "analysis/loop/loop_analysis.h"

/** `base` is invariant. True if its evaluation reads no memory, or if the pointer that it is
 * read through is dereferenced anyway, in each iteration or by the loop's bound: then it is not
 * an optional one that may be null. For an element of an array: if that element is read anyway. */
bool base_can_be_read_before(const loop_analysis *j, const ir_node *base);

/** Does each iteration dereference the pointer through which `load` reads a member? Then the load
 * may be made even if the program does not make it. False for paths with subscripts. */
bool base_is_in_object_read(const loop_analysis *j, const ir_node *load);

#endif
