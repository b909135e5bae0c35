/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Loops whose condition also steps the counter: `while (n--)`, `for (i = n; --i >= 0;)`. Used only
 *  by counted.c. */
#ifndef ANALYSIS_COUNTED_CONDITION_H
#define ANALYSIS_COUNTED_CONDITION_H

#include "analysis/base/facts.h"

/** Fills in counter, step, increment, comparison and bound, in terms of the stepped counter, and
 *  sets steps_first and ends_below. False: the condition has another form. */
bool counted_split_stepping(const ir_node *condition, counted_loop *counted);

/** May the counter leave its type, or does a conversion change it or the bound for the comparison?
 *  The step past 0 by which `i-- > 0` ends for an unsigned i does not count. */
bool counted_stepping_wraps(const counted_loop *counted);

#endif
