/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds irregular reductions that may run in parallel, and the reasons for which other loops may
 *  not.
 *
 *  The analysis consists of functions from IR to facts. A fact describes the loop; the verdict
 *  draws the conclusion.
 *
 *  A loop is accepted (docs/soundness.md) if
 *  - every access to the memory of a reduction array, through any name, is an update whose value is
 *    not used, and the order is kept if updates do not commute;
 *  - subscripts, contributions and conditions do not depend on that memory;
 *  - nothing else is carried from one iteration to another.
 *  Each of these is proved or guarded at run time; otherwise the loop is refused. */
#ifndef ANALYSIS_ANALYSIS_H
#define ANALYSIS_ANALYSIS_H

#include "analysis/base/facts.h"

typedef struct analysis_result {
    unsigned verdict_count;
    const loop_verdict *verdicts; /* verdicts on the loops that are reported (nest.c), in source
                                   * order */
} analysis_result;

/** Analyses all loops in functions of the main file and of the program's own headers. All results
 *  are allocated in the arena. */
analysis_result analyse(arena *a, const ir_unit *unit, const analysis_options *options);

/** Like analyse. If `calls` is not NULL, also appends to *calls the calls that updating_calls.h
 *  describes, in loops that stay sequential. */
analysis_result analyse_listing(arena *a, const ir_unit *unit, const analysis_options *options,
                                updating_calls *calls);

#endif
