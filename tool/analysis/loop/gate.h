/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What keeps a loop from being rewritten, whatever it computes. */
#ifndef ANALYSIS_GATE_H
#define ANALYSIS_GATE_H

#include "analysis/loop/loop_analysis.h"

/** May the loop's text be rewritten at all, and is it left only at its end? */
reason check_text(const loop_analysis *j);
reason check_jumps(const loop_analysis *j);

typedef struct access_result {
    reason why;
    access_list found;     /* as the summaries give them */
    unsigned count;        /* of the same, with where in memory they are: */
    loop_access *accesses; /* all of CLASS_OPEN */
} access_result;

/** Lists all accesses of one iteration, header included; refuses what is not understood. */
access_result check_accesses(const loop_analysis *j);

#endif
