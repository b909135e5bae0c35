/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Recognises conditions that also step the counter: `while (n--)`, `for (i = n; --i >= 0;)`. Only
 *  counted.c uses this header. */
#ifndef ANALYSIS_COUNTED_CONDITION_H
#define ANALYSIS_COUNTED_CONDITION_H

#include "analysis/base/facts.h"

/** Compares a bare counter, as in `while (n)`, with the int 0, which is stored as the bound. */
void counted_split_bare(counted_loop *counted);

/** Was the bound stored by counted_split_bare or by counted_split_stepping for a bare `n--`? */
bool counted_is_bare(const counted_loop *counted);

/** Fills in counter, step, increment, comparison and bound, and sets steps_first and ends_below.
 *  The comparison applies to the counter after the step. Returns false if the condition has another
 *  form. */
bool counted_split_stepping(const ir_node *condition, counted_loop *counted);

/** May the counter overflow, or may a conversion change it or the bound in the comparison? The step
 *  below 0 with which `i-- > 0` ends for an unsigned i is not counted as overflow. */
bool counted_stepping_wraps(const counted_loop *counted);

#endif
