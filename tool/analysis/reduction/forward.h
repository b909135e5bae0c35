/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Store forwarding: elements that an iteration stores and then reads:
 *
 *     o[t] = e;  h[o[t]] += w[t];
 *
 * Such a read may use a variable with the value. The memory is not yet written when the inspector
 * runs; in the executor another thread may write it.
 */
#ifndef ANALYSIS_FORWARD_H
#define ANALYSIS_FORWARD_H

#include "analysis/loop/loop_analysis.h"

/** Is `store` a plain store in the loop's text, and can all reads that certainly overlap it use the
 *  value? Then they get CLASS_FORWARDED, and the store is added to j->forwards. */
bool forward_take(loop_analysis *j, const loop_access *store);

/** The forwarded store whose value this node of the loop uses: its number in j->forwards; or -1. */
int forward_read(const loop_analysis *j, const ir_node *node);

#endif
