/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The backward slice: the statements and control of a loop's body that compute the addresses for
 * the inspector.
 */
#ifndef ANALYSIS_SLICE_H
#define ANALYSIS_SLICE_H

#include "analysis/loop/loop_analysis.h"

/** An address to be recorded before a statement. */
typedef struct slice_touch {
    const ir_node *row;
    unsigned loop_count; /* as in loop_source */
    const source_loop *loops;
    const ir_node *place;
} slice_touch;

typedef struct slice {
    bool *keep;            /* [function->node_count] */
    unsigned needed_count; /* variables of the iteration that it uses */
    const ir_variable **needed;
    uint64_t own; /* bits, by number: own elements whose values it needs */
    bool has_floating_work;
    const ir_node *obstacle; /* the node that prevents a slice; NULL: there is a slice */
} slice;

/** The slice of all touches together. */
slice slice_compute(const loop_analysis *j, unsigned touch_count, const slice_touch *touches);

#endif
