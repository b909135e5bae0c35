/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What keeps a loop from being rewritten, whatever it computes. */
#ifndef ANALYSIS_GATE_H
#define ANALYSIS_GATE_H

#include "analysis/loop/judgement.h"

/** May the loop's text be rewritten at all, and is it left only at its end? */
bool judge_text(judgement *j);
bool judge_jumps(judgement *j);

/** Lists all accesses of one iteration, header included; refuses what is not understood. */
bool judge_accesses(judgement *j);

#endif
