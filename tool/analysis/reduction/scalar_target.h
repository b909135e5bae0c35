/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Scalars that are no variables of their own: members of a record, elements, what a pointer leads
 * to. */
#ifndef ANALYSIS_SCALAR_TARGET_H
#define ANALYSIS_SCALAR_TARGET_H

#include "analysis/loop/loop_analysis.h"

/** Is it one object in all iterations, found by what stays: m.x, e[2], *p, p->energy? */
bool scalar_target_stays(const loop_analysis *j, const ir_node *target);

/** May it be, as far as is known, what the loop accesses otherwise than by this very expression? */
overlap scalar_target_meets(const loop_analysis *j, const ir_node *target);

#endif
