/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Checks that pointers that a loop loads through others are loop-invariant. */
#ifndef ANALYSIS_LOADS_STAY_H
#define ANALYSIS_LOADS_STAY_H

#include "analysis/loop/loop_analysis.h"

/** True: nothing in the loop writes the pointers, or those they are loaded through, under any name.
 *  Proved, not guarded. */
bool loads_stay(const analyser *an, const ir_node *loop, const loop_loads *loads);

#endif
