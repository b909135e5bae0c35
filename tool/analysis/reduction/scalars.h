/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Scalars that a loop accumulates into, in addition to its arrays: s += e, s -= e, s = s * e,
 *  count++. */
#ifndef ANALYSIS_SCALARS_H
#define ANALYSIS_SCALARS_H

#include "analysis/loop/loop_analysis.h"

/** Accepts the write as an update of a scalar whose operands are kept for each iteration and
 *  applied in order after the loop. False: it is none; nothing is changed. */
bool scalar_take_update(loop_analysis *j, loop_access *write);

/** Checks, when all writes are classified, that nothing else in the loop reads or writes them. */
reason check_scalars(const loop_analysis *j);

#endif
