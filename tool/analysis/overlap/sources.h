/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Reads against the reduction arrays: each read of the loop is proved disjoint from them, or needs
 *  the overlap guard, or the loop is refused. */
#ifndef ANALYSIS_SOURCES_H
#define ANALYSIS_SOURCES_H

#include "analysis/loop/loop_analysis.h"

typedef struct source_result {
    reason why;
    loop_access *accesses; /* each read with its class, and whether it needs the guard */
    array_list arrays;     /* interleaved if another field is read through the same base */
} source_result;

source_result check_sources(const loop_analysis *j);

#endif
