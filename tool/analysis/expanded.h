/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The analysis of a unit's loops, with calls expanded where that lets a loop run in parallel. */
#ifndef ANALYSIS_EXPANDED_H
#define ANALYSIS_EXPANDED_H

#include "analysis/analysis.h"

/** As analyse. A call that updates elements which iterations share is expanded
 *  (base/expanded_call.h), and stays so in the unit if code is generated for a loop around it. */
analysis_result analyse_expanding(arena *a, ir_unit *unit, const analysis_options *options);

#endif
