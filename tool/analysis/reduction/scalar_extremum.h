/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Minima and maxima of scalars, perhaps with the iteration that set them. */
#ifndef ANALYSIS_SCALAR_EXTREMUM_H
#define ANALYSIS_SCALAR_EXTREMUM_H

#include "analysis/loop/loop_analysis.h"

/** if (e > s) { s = e; at = i; }, s = e > s ? e : s and the like, containing `assignment` of s or
 *  at: sets all of `found` except for the operand's type. False: another form. */
bool scalar_extremum_of(const loop_analysis *j, const ir_node *assignment, scalar_update *found);

#endif
