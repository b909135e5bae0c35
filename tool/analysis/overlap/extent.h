/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The extent of a read: how the memory that it may touch in all iterations is determined, for the
 *  overlap guard and for the comparison of subscripts. */
#ifndef ANALYSIS_EXTENT_H
#define ANALYSIS_EXTENT_H

#include "analysis/loop/loop_analysis.h"

typedef struct source_plan {
    bool is_possible; /* its extent can be determined */
    loop_source source;
} source_plan;

/** How to determine the extent of a read. `of_contents`: it must contain only bytes that are really
 *  read, because they will be compared. */
source_plan source_plan_of(const loop_analysis *j, const loop_access *read, bool of_contents);

/** Plans of the first and the last element that a look-up reads, if access.to is set; it reads all
 *  elements between them as well. False: one of them cannot be recorded. */
bool source_plans_of_search(const loop_analysis *j, const loop_access *read, source_plan *first,
                            source_plan *last);

#endif
