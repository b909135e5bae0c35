/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Minima and maxima of scalars, with the place where they were found. Of scalars.c. */
#ifndef ANALYSIS_SCALAR_EXTREMUM_H
#define ANALYSIS_SCALAR_EXTREMUM_H

#include "analysis/loop/loop_analysis.h"

/** if (e > s) { s = e; at = i; }, s = e > s ? e : s and the like, with `assignment` of s or at in
 *  it: fills all of `found` but for the operand's type. False: it is none. */
bool scalar_extremum_of(const loop_analysis *j, const ir_node *assignment, scalar_update *found);

#endif
