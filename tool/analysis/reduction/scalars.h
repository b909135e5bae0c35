/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Scalars into which a loop accumulates, in addition to its arrays: s += e, s -= e, s = s * e,
 *  count++. */
#ifndef ANALYSIS_SCALARS_H
#define ANALYSIS_SCALARS_H

#include "analysis/loop/loop_analysis.h"

/** Accepts the write as an update of a scalar, whose operands are then stored in each iteration and
 *  applied in order after the loop. Returns false and changes nothing if the write is no update of
 *  a scalar. */
bool scalar_take_update(loop_analysis *j, loop_access *write);

/** Checks, once all writes are classified, that each scalar is accessed only by its updates, and
 *  that an iteration may combine their operands. Accesses that a guard compares are permitted. */
reason check_scalars(const loop_analysis *j);

#endif
