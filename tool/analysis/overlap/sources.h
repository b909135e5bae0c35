/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The loop's reads: extents of those that must be guarded or compared. */
#ifndef ANALYSIS_SOURCES_H
#define ANALYSIS_SOURCES_H

#include "analysis/loop/loop_analysis.h"

typedef struct source_plan {
    bool is_possible; /* its extent can be determined */
    loop_source source;
} source_plan;

/** How to determine the extent of a read. `of_contents`: it must contain only bytes that are really
 *  read, because they will be compared. */
source_plan source_plan_of(const loop_analysis *j, const loop_access *read, bool of_contents);

/** The first and the last element that a look-up reads of a row, if access.to is set: it reads all
 *  elements between them as well. */
bool source_plans_of_search(const loop_analysis *j, const loop_access *read, source_plan *first,
                            source_plan *last);

typedef struct source_result {
    reason why;
    loop_access *accesses; /* each read with its class, and whether it needs the guard */
    array_list arrays;     /* interleaved if another field is read through the same base */
} source_result;

/** Reads against arrays: disjoint, guarded, or refused. */
source_result check_sources(const loop_analysis *j);

#endif
