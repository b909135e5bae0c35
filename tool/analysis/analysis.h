/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Finds the irregular reductions that may run in parallel, and the reasons why other loops may not.
 *
 * Functions from IR to facts. A fact describes the loop; the verdict draws the conclusion.
 * The rule (docs/soundness.md): every access in the loop, through any name, to the memory of a
 * reduction array is an update whose value is not used, with the order kept if updates do not
 * commute; subscripts, contributions and conditions do not depend on that memory; nothing else is
 * carried from one iteration to another. Proved, or guarded at run time, or refused.
 */
#ifndef ANALYSIS_ANALYSIS_H
#define ANALYSIS_ANALYSIS_H

#include "analysis/base/facts.h"

typedef struct analysis_result {
    unsigned verdict_count;
    const loop_verdict *verdicts; /* of the loops that are reported (nest.c), in source order */
} analysis_result;

/** Analyses all loops of the functions of the main file, and of the program's own headers. All
 *  results are allocated in the arena. */
analysis_result analyse(arena *a, const ir_unit *unit, const analysis_options *options);

/** The same; also appends the calls that update shared elements in loops that stay sequential. */
analysis_result analyse_listing(arena *a, const ir_unit *unit, const analysis_options *options,
                                updating_calls *calls);

#endif
