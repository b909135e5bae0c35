/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The updates of a loop, and the arrays that they go to. */
#ifndef ANALYSIS_UPDATES_H
#define ANALYSIS_UPDATES_H

#include "analysis/loop/loop_analysis.h"

/** Finds updates and their arrays, decides which writes are private, refuses all others. */
bool check_updates(loop_analysis *j);

#endif
