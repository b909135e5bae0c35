/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Determines the extent of a read (the range of memory that it may touch in all iterations), for
 *  the overlap guard and for the comparison of subscripts. */
#ifndef ANALYSIS_EXTENT_H
#define ANALYSIS_EXTENT_H

#include "analysis/loop/loop_analysis.h"

typedef struct source_plan {
    bool is_possible; /* the extent can be determined */
    loop_source source;
} source_plan;

/** How to determine the extent of a read. If `of_contents` is set, the extent must contain only
 *  bytes that are really read, because their contents will be compared. */
source_plan source_plan_of(const loop_analysis *j, const loop_access *read, bool of_contents);

/** Stores how to determine the first and the last element that a linear search reads (access.from
 *  and access.to). It reads all elements between them as well. Returns false if the inspector
 *  cannot record one of the two. */
bool source_plans_of_search(const loop_analysis *j, const loop_access *read, source_plan *first,
                            source_plan *last);

#endif
