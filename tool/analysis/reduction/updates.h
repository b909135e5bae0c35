/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The updates of a loop, and the arrays that they go to. */
#ifndef ANALYSIS_UPDATES_H
#define ANALYSIS_UPDATES_H

#include "analysis/loop/loop_analysis.h"

typedef struct update_result {
    reason why;
    unsigned access_count;
    loop_access *accesses; /* each write with its class, and reads that updates or stores explain */
    array_list arrays;
    update_list updates;
    scalar_list scalars;
    forward_list forwards;
    own_list own;
    private_list privates; /* all of them, including those that the header steps */
} update_result;

/** Finds updates and their arrays, decides which writes are private, refuses all others. */
update_result check_updates(const loop_analysis *j);

#endif
