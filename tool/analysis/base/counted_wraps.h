/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Checks whether a loop's counter may overflow. Only counted.c uses this header. */
#ifndef ANALYSIS_COUNTED_WRAPS_H
#define ANALYSIS_COUNTED_WRAPS_H

#include "analysis/base/facts.h"

/** May an integer counter wrap around before it reaches the bound, or may a conversion change the
 *  counter or the bound in the comparison? The loop's counter, lower, bound, comparison and step
 *  must be set. */
bool counted_wraps(const counted_loop *loop);

/** Does the counter's final value, computed in 64 bits, show whether the counter wrapped around?
 *  True for an unsigned counter of at least 4 bytes that is compared by < with a bound of no wider
 *  type. Its step must be greater than 1 or not constant. */
bool counted_wrap_is_seen(const counted_loop *loop);

#endif
