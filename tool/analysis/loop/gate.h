/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds reasons not to transform a loop that are independent of its computation. */
#ifndef ANALYSIS_GATE_H
#define ANALYSIS_GATE_H

#include "analysis/loop/loop_analysis.h"

/** check_text finds a reason in the file's text or its options for which the loop is refused.
 *  check_jumps finds a jump by which control leaves or enters the loop. The result's id is
 *  REASON_NONE if there is no reason. */
reason check_text(const loop_analysis *j);
reason check_jumps(const loop_analysis *j);

typedef struct access_result {
    reason why;
    access_list found;     /* all accesses, as access_collect lists them */
    unsigned count;        /* number of `accesses`, which are those of `found` with their
                            * locations */
    loop_access *accesses; /* each has the class CLASS_OPEN */
} access_result;

/** Lists all accesses of one iteration, including those of the loop's bound. Refuses the loop if an
 *  access or call is not supported. */
access_result check_accesses(const loop_analysis *j);

#endif
