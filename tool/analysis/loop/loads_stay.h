/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Proves that the pointers which a loop loads through other pointers (loop_loads.h) are
 *  loop-invariant. */
#ifndef ANALYSIS_LOADS_STAY_H
#define ANALYSIS_LOADS_STAY_H

#include "analysis/loop/loop_analysis.h"

/** True if nothing in the loop can write the pointers in `loads`, or the pointers through which
 *  they are loaded, under any name. No guard at run time is used for this. */
bool loads_stay(const analyser *an, const ir_node *loop, const loop_loads *loads);

#endif
