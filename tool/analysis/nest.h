/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Selects which loops of a function's nests are analysed, and which are reported. */
#ifndef ANALYSIS_NEST_H
#define ANALYSIS_NEST_H

#include "analysis/loop/loop_analysis.h"

typedef struct loop_search {
    const analyser *an;
    ir_function *function; /* the function being searched */
    VECTOR(loop_verdict) verdicts;
    updating_calls *calls; /* calls in loops that stay sequential (updating_calls.h); NULL if they
                            * need not be listed */
} loop_search;

/** Analyses all loops of the function and appends the verdicts, in source order, and the calls. */
void check_loops(loop_search *s, ir_function *function);

#endif
