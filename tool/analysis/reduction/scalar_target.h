/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Scalars that are not separate variables: members of a record, elements, targets of pointers. */
#ifndef ANALYSIS_SCALAR_TARGET_H
#define ANALYSIS_SCALAR_TARGET_H

#include "analysis/loop/loop_analysis.h"

/** Is it one object in all iterations, reached through invariants: m.x, e[2], *p, p->energy? */
bool scalar_target_is_invariant(const loop_analysis *j, const ir_node *target);

/** The worst overlap of the target, or a variable, with accesses by other expressions of the loop.
 */
overlap scalar_target_overlap(const loop_analysis *j, const ir_node *target);

#endif
