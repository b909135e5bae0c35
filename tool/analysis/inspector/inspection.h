/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Determines the contents of the inspector, and whether its plan may be kept for later
 *  executions. */
#ifndef ANALYSIS_INSPECTION_H
#define ANALYSIS_INSPECTION_H

#include "analysis/loop/loop_analysis.h"

typedef struct slice_result {
    reason why;
    private_list privates; /* is_in_slice is set */
    own_list own;          /* is_in_slice is set */
    source_list sources;   /* in the order in which the slice reads them */
    key_list key;
    loop_slice slice;
} slice_result;

/** Computes the slice, which determines rows and touched sources, and whether a plan may be kept.
 *  If the rows cannot be computed twice, the slice is only for the sources. */
slice_result check_slice(const loop_analysis *j);

#endif
