/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Can the counter of a loop leave its type? Used only by counted.c. */
#ifndef ANALYSIS_COUNTED_WRAPS_H
#define ANALYSIS_COUNTED_WRAPS_H

#include "analysis/base/facts.h"

/** May an integer counter wrap around before it reaches the bound, or does a conversion change it
 * or the bound for the comparison? Requires counter, lower, bound, comparison and step. */
bool counted_wraps(const counted_loop *loop);

/** Does the value after the loop, computed in 64 bits, show whether the counter wrapped around?
 *  True for an unsigned counter of at least 4 bytes that is compared by < with a bound of at
 * most its size, in steps that are longer than 1 or not constant. */
bool counted_wrap_is_seen(const counted_loop *loop);

#endif
