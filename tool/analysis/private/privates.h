/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds the variables that are private to iterations, and those that the loop only reads. */
#ifndef ANALYSIS_PRIVATES_H
#define ANALYSIS_PRIVATES_H

#include "analysis/loop/loop_analysis.h"

typedef struct private_check {
    reason why;
    private_list privates;  /* each with the way in which it gets its last value */
    variable_list captured; /* scalars and structs that are declared outside the loop, that the loop
                             * only reads, and that threads may copy; in order of first use */
    bool counter_is_live_after;
} private_check;

/** Decides how private variables get their last values, and sets this in `privates`. Also lists the
 *  variables that the loop only reads. */
private_check check_privates(const loop_analysis *j);

#endif
