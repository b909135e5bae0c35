/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Compares the loop's reads with the reduction arrays. Each read is proved disjoint from them or
 *  is marked for the overlap guard; otherwise the loop is refused. */
#ifndef ANALYSIS_SOURCES_H
#define ANALYSIS_SOURCES_H

#include "analysis/loop/loop_analysis.h"

typedef struct source_result {
    reason why;
    loop_access *accesses; /* each read has its class, and needs_guard is set for those that a guard
                            * must compare */
    array_list arrays;     /* is_interleaved is set if another field is read through the same
                            * base */
} source_result;

source_result check_sources(const loop_analysis *j);

#endif
