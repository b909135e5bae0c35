/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds the variables that are private to iterations, and those that the loop only reads. */
#ifndef ANALYSIS_PRIVATES_H
#define ANALYSIS_PRIVATES_H

#include "analysis/loop/loop_analysis.h"

typedef struct private_check {
    reason why;
    private_list privates;  /* includes how each gets its last value */
    variable_list captured; /* variables declared outside that the loop only reads, in the order
                             * of use */
    bool counter_is_live_after;
} private_check;

/** Decides how private variables get their last values. Also lists the other variables that the
 *  loop reads. */
private_check check_privates(const loop_analysis *j);

#endif
