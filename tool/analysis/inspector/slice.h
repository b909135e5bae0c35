/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The backward slice: those statements and control structures of a loop's body that compute
 *  addresses for the inspector. */
#ifndef ANALYSIS_SLICE_H
#define ANALYSIS_SLICE_H

#include "analysis/loop/loop_analysis.h"

/** The address of an updated row or of a source, which the inspector records just before the
 *  statement `place`. */
typedef struct slice_touch {
    const ir_node *row;
    unsigned loop_count; /* as in loop_source */
    const source_loop *loops;
    const ir_node *place;
} slice_touch;

typedef struct slice {
    bool *keep;            /* keep[id] says whether the function's node with this id is in the
                            * slice */
    unsigned needed_count; /* number of private variables that the slice uses */
    const ir_variable **needed;
    uint64_t own; /* a set of bits: the indices of own elements whose values the slice needs */
    bool has_floating_work;
    const ir_node *obstacle; /* the node that prevents a slice; NULL if there is a slice */
} slice;

/** Computes one slice for all touches together. */
slice slice_compute(const loop_analysis *j, unsigned touch_count, const slice_touch *touches);

#endif
