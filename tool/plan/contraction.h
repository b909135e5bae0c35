/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Where the written text forbids to contract a multiplication and an addition into one rounding.
 */
#ifndef PLAN_CONTRACTION_H
#define PLAN_CONTRACTION_H

#include "analysis/analysis.h"
#include "plan/options.h"

typedef enum contraction {
    CONTRACTION_ALLOWED,
    CONTRACTION_OFF_IN_LOOPS, /* and in the functions around them, where compilers need that */
    CONTRACTION_OFF_IN_FILE
} contraction;

/** Of all loops that are to be transformed. is_forbidden: [verdicts] becomes true where it is
 * forbidden in the loop itself: something in it, or in what it calls, could be contracted, perhaps
 * with what stands outside. */
contraction contraction_of(arena *a, const ir_unit *unit, const analysis_result *analysis,
                           const plan_options *options, bool has_lanes, bool *is_forbidden);

/** May functions be compiled for processors that the file's head knows nothing of? */
bool may_name_targets(const ir_unit *unit);

#endif
