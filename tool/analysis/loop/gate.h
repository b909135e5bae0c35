/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What keeps a loop from being rewritten, whatever it computes. */
#ifndef ANALYSIS_GATE_H
#define ANALYSIS_GATE_H

#include "analysis/loop/loop_analysis.h"

/** May the loop's text be rewritten at all, and is it left only at its end? */
bool check_text(loop_analysis *j);
bool check_jumps(loop_analysis *j);

/** Lists all accesses of one iteration, header included; refuses what is not understood. */
bool check_accesses(loop_analysis *j);

#endif
