/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Analyses a unit's loops, and expands calls if a loop can then run in parallel. */
#ifndef ANALYSIS_EXPANDED_H
#define ANALYSIS_EXPANDED_H

#include "analysis/analysis.h"

/** Like analyse (analysis.h). Also expands calls that update elements which several iterations may
 *  update (base/expanded_call.h). A call stays expanded in the unit if code is generated for a loop
 *  around it. */
analysis_result analyse_expanding(arena *a, ir_unit *unit, const analysis_options *options);

#endif
