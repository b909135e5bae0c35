/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds the updates of a loop and the arrays to which they belong. */
#ifndef ANALYSIS_UPDATES_H
#define ANALYSIS_UPDATES_H

#include "analysis/loop/loop_analysis.h"

typedef struct update_result {
    reason why;
    unsigned access_count;
    loop_access *accesses; /* all accesses of the loop, with the classes assigned so far */
    array_list arrays;
    update_list updates;
    scalar_list scalars;
    forward_list forwards;
    own_list own;
    private_list privates; /* includes the variables that the header steps */
} update_result;

/** Classifies each write of the loop. Refuses the loop at the first write that has no class. */
update_result check_updates(const loop_analysis *j);

#endif
