/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Handles scalars that are not variables themselves: members of a record, elements, and targets of
 *  pointers. */
#ifndef ANALYSIS_SCALAR_TARGET_H
#define ANALYSIS_SCALAR_TARGET_H

#include "analysis/loop/loop_analysis.h"

/** Is the target the same object in all iterations, reached through invariants: m.x, e[2], *p,
 *  p->energy? */
bool scalar_target_is_invariant(const loop_analysis *j, const ir_node *target);

/** The worst overlap of the target, or of a variable, with accesses of the loop by other
 *  expressions. */
overlap scalar_target_overlap(const loop_analysis *j, const ir_node *target);

#endif
