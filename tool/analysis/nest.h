/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The loops of a function: which of a nest are analysed, and of which something is said. */
#ifndef ANALYSIS_NEST_H
#define ANALYSIS_NEST_H

#include "analysis/loop/loop_analysis.h"

typedef struct loop_search {
    const analyser *an;
    ir_function *function; /* the one that is searched now */
    VECTOR(loop_verdict) verdicts;
} loop_search;

/** Analyses all loops of the function and appends the verdicts, in source order. */
void check_loops(loop_search *s, ir_function *function);

#endif
