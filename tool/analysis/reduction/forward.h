/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Elements that an iteration stores and then reads:
 *
 *     o[t] = e;  h[o[t]] += w[t];
 *
 * Such a read may take the value from a variable instead of the memory, which is not yet written
 * when the inspector reads it, and is another thread's to write when the executor does.
 */
#ifndef ANALYSIS_FORWARD_H
#define ANALYSIS_FORWARD_H

#include "analysis/loop/loop_analysis.h"

/** Can all other reads of what `store` writes (a plain store in the loop's text) take the value?
 *  Then they get CLASS_FORWARDED, and the store is noted in j->forwards. */
bool forward_take(loop_analysis *j, const loop_access *store);

/** The stored value that this node of the loop stands for: its number in j->forwards; or -1. */
int forward_read(const loop_analysis *j, const ir_node *node);

#endif
