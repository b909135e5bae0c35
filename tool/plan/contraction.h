/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Decides where the written text forbids to contract a multiplication and an addition into one
 *  rounding. */
#ifndef PLAN_CONTRACTION_H
#define PLAN_CONTRACTION_H

#include "analysis/analysis.h"
#include "plan/options.h"

typedef enum contraction {
    CONTRACTION_ALLOWED,
    CONTRACTION_OFF_IN_LOOPS, /* and in the functions around them, if compilers need that */
    CONTRACTION_OFF_IN_FILE
} contraction;

/** For all loops to be transformed. Sets is_forbidden [verdicts] if it is forbidden in the loop
 *  itself: an operation in it, or in a function it calls, could be contracted, perhaps with one
 *  outside. */
contraction contraction_of(arena *a, const ir_unit *unit, const analysis_result *analysis,
                           const plan_options *options, bool has_lanes, bool *is_forbidden);

/** May functions be compiled for processors that the file's head does not show? */
bool may_name_targets(const ir_unit *unit);

#endif
