/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The private variables of iterations. */
#ifndef ANALYSIS_PRIVATES_H
#define ANALYSIS_PRIVATES_H

#include "analysis/loop/loop_analysis.h"

typedef struct private_check {
    reason why;
    private_list privates;  /* with the treatment of their last values */
    variable_list captured; /* declared outside, only read in the loop, in order of use */
    bool counter_is_live_after;
} private_check;

/** Decides how private variables get their last values; lists the other variables that are read. */
private_check check_privates(const loop_analysis *j);

#endif
