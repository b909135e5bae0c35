/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Can the counter of a loop leave its type? Of counted.c only. */
#ifndef ANALYSIS_COUNTED_WRAPS_H
#define ANALYSIS_COUNTED_WRAPS_H

#include "analysis/base/facts.h"

/** May an integer counter pass the end of its type before it reaches the bound, or be compared as
 *  another number than it is? counter, lower, bound, comparison and step are known. */
bool counted_wraps(const counted_loop *loop);

/** Is it seen in the value after the loop, computed in 64 bits, whether the counter wraps? Of an
 *  unsigned one that goes up to a bound of no more bytes, in steps longer than 1. */
bool counted_wrap_is_seen(const counted_loop *loop);

#endif
