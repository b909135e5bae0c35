/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Scalars that a loop accumulates into, in addition to its arrays: s += e, s -= e, s = s * e,
 *  count++. */
#ifndef ANALYSIS_SCALARS_H
#define ANALYSIS_SCALARS_H

#include "analysis/loop/loop_analysis.h"

/** Accepts the write as an update of a scalar whose operands are kept for each iteration and
 *  applied in order after the loop. False: it is no such update, and nothing is changed. */
bool scalar_take_update(loop_analysis *j, loop_access *write);

/** Once all writes are classified: do only a scalar's updates access it, and may an iteration
 * combine their operands? Accesses that a guard compares are permitted. */
reason check_scalars(const loop_analysis *j);

#endif
