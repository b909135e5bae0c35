/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Are pointers that a loop reads through others the same whenever it reads them? */
#ifndef ANALYSIS_LOADS_STAY_H
#define ANALYSIS_LOADS_STAY_H

#include "analysis/loop/loop_analysis.h"

/** Nothing in the loop writes them, nor what leads to them, by any name: proved, not guarded. */
bool loads_stay(const analyser *an, const ir_node *loop, const loop_loads *loads);

#endif
