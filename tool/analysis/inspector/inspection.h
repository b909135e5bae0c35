/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What the inspector does, and whether its plan may be kept. */
#ifndef ANALYSIS_INSPECTION_H
#define ANALYSIS_INSPECTION_H

#include "analysis/loop/loop_analysis.h"

/** What computes rows and touched sources, and whether a plan may be kept. */
bool check_slice(loop_analysis *j);

#endif
