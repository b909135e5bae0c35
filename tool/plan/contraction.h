/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Decides where the written text forbids the compiler to contract a multiplication and an addition
 *  into an operation with one rounding (FMA). */
#ifndef PLAN_CONTRACTION_H
#define PLAN_CONTRACTION_H

#include "analysis/analysis.h"
#include "plan/options.h"

typedef enum contraction {
    CONTRACTION_ALLOWED,
    CONTRACTION_OFF_IN_LOOPS, /* and in the functions around the loops, if compilers need that */
    CONTRACTION_OFF_IN_FILE
} contraction;

/** Decides where contraction is turned off, for all loops to be transformed. If the result is
 * CONTRACTION_OFF_IN_LOOPS, sets is_forbidden[] by verdict: true if the loop, or a function that it
 * calls, has an operation that could be contracted, perhaps with one outside. */
contraction contraction_of(arena *a, const ir_unit *unit, const analysis_result *analysis,
                           const plan_options *options, bool has_lanes, bool *is_forbidden);

/** May an attribute or pragma of the file select another processor for functions? The text at the
 * beginning of the written file cannot test the macros of that processor. */
bool may_name_targets(const ir_unit *unit);

#endif
