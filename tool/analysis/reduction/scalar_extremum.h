/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Recognises minima and maxima of scalars, perhaps together with the iteration that set them. */
#ifndef ANALYSIS_SCALAR_EXTREMUM_H
#define ANALYSIS_SCALAR_EXTREMUM_H

#include "analysis/loop/loop_analysis.h"

/** Recognises if (e > s) { s = e; at = i; }, s = e > s ? e : s and the like. `assignment` is the
 *  assignment of s or of `at`. Sets all fields of *found except the operand's type. Returns false
 *  if the statement has another form. */
bool scalar_extremum_of(const loop_analysis *j, const ir_node *assignment, scalar_update *found);

#endif
