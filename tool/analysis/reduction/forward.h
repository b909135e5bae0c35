/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Store forwarding, for elements that an iteration stores and then reads:
 *
 *      o[t] = e; h[o[t]] += w[t];
 *
 *  The read uses a variable that has the stored value. It must not use memory: when the inspector
 *  runs, the element has not been written yet, and in the executor another thread may write it. */
#ifndef ANALYSIS_FORWARD_H
#define ANALYSIS_FORWARD_H

#include "analysis/loop/loop_analysis.h"

/** Is `store` a plain store in the loop's text, and can all reads that certainly overlap it use its
 *  value? If so, gives these reads CLASS_FORWARDED, adds the store to j->forwards, and returns
 *  true. */
bool forward_take(loop_analysis *j, const loop_access *store);

/** The index in j->forwards of the store whose value this node of the loop uses; -1 if there is
 *  none. */
int forward_read(const loop_analysis *j, const ir_node *node);

#endif
