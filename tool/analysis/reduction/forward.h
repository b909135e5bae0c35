/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Store forwarding: elements that an iteration stores and then reads:
 *
 *     o[t] = e;  h[o[t]] += w[t];
 *
 * Such a read may use a variable with the value instead of the memory, which is not yet written
 * when the inspector reads it, and may be written by another thread in the executor.
 */
#ifndef ANALYSIS_FORWARD_H
#define ANALYSIS_FORWARD_H

#include "analysis/loop/loop_analysis.h"

/** Can all other reads of the memory that `store` writes (a plain store in the loop's text) use the
 *  value? Then they get CLASS_FORWARDED, and the store is added to j->forwards. */
bool forward_take(loop_analysis *j, const loop_access *store);

/** The forwarded store whose value this node of the loop uses: its number in j->forwards; or -1. */
int forward_read(const loop_analysis *j, const ir_node *node);

#endif
