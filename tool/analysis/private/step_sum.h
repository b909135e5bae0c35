/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Computes how much each iteration adds to an induction variable (induction.h), perhaps through
 *  copies in other variables: `q = p + n; ... p = q + n;`. */
#ifndef ANALYSIS_STEP_SUM_H
#define ANALYSIS_STEP_SUM_H

#include "analysis/loop/loop_analysis.h"

/** Is the write executed exactly once in each iteration, in the body or in the header of a `for`?
 */
bool step_is_in_each(const loop_analysis *j, const ir_node *write);

/** Does the loop change item->variable only by adding the same amount in each iteration? If so,
 *  stores the amount in `step`, `strides` and `inner` of *item. */
bool step_sum(const loop_analysis *j, private_variable *item);

#endif
