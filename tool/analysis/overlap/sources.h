/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Where the loop reads: extents of what must be guarded or checked. */
#ifndef ANALYSIS_SOURCES_H
#define ANALYSIS_SOURCES_H

#include "analysis/loop/loop_analysis.h"

typedef struct source_plan {
    bool is_possible; /* its extent can be told */
    loop_source source;
} source_plan;

/** How the extent of a read access can be told. `of_contents`: bytes that are not really read must
 *  not be in it either, since they will be compared. */
source_plan source_plan_of(const loop_analysis *j, const loop_access *read, bool of_contents);

/** The first and the last element that a look-up reads of a row, where access.to is set: all
 *  between is read as well. */
bool source_plans_of_search(const loop_analysis *j, const loop_access *read, source_plan *first,
                            source_plan *last);

typedef struct source_result {
    reason why;
    loop_access *accesses; /* each read with its class, and whether it needs the guard */
    array_list arrays;     /* interleaved where another field is read through the same base */
} source_result;

/** Reads against arrays: apart, guarded, or refused. */
source_result check_sources(const loop_analysis *j);

#endif
