/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Reasons against rewriting a loop, whatever it computes. */
#ifndef ANALYSIS_GATE_H
#define ANALYSIS_GATE_H

#include "analysis/loop/loop_analysis.h"

/** Reasons against rewriting the loop's text, and jumps by which control leaves or enters it. */
reason check_text(const loop_analysis *j);
reason check_jumps(const loop_analysis *j);

typedef struct access_result {
    reason why;
    access_list found;     /* from the summaries */
    unsigned count;        /* the same, with their locations in memory: */
    loop_access *accesses; /* all of CLASS_OPEN */
} access_result;

/** Lists all accesses of one iteration, including those of the loop's bound; refuses constructs
 * that are not supported. */
access_result check_accesses(const loop_analysis *j);

#endif
