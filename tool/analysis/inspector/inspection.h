/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The contents of the inspector, and whether its plan may be kept. */
#ifndef ANALYSIS_INSPECTION_H
#define ANALYSIS_INSPECTION_H

#include "analysis/loop/loop_analysis.h"

typedef struct slice_result {
    reason why;
    private_list privates; /* with is_in_slice */
    own_list own;          /* likewise */
    source_list sources;   /* in the order in which the slice reads them */
    key_list key;
    loop_slice slice;
} slice_result;

/** The code that computes rows and touched sources, and whether a plan may be kept. If the rows
 *  cannot be computed a second time, the code is for the sources alone. */
slice_result check_slice(const loop_analysis *j);

#endif
