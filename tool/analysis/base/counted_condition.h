/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Loops whose condition steps the counter as well: `while (n--)`, `for (i = n; --i >= 0;)`. Of
 *  counted.c only. */
#ifndef ANALYSIS_COUNTED_CONDITION_H
#define ANALYSIS_COUNTED_CONDITION_H

#include "analysis/base/facts.h"

/** Fills in counter, step, increment, comparison and bound, as of the counter that was stepped, and
 *  sets steps_first and ends_below. False: the condition is none of these. */
bool counted_split_stepping(const ir_node *condition, counted_loop *counted);

/** May the counter leave its type, or be compared as another number than it is? Its own step past
 *  0, by which `i-- > 0` ends for an unsigned i, is none of this. */
bool counted_stepping_wraps(const counted_loop *counted);

#endif
