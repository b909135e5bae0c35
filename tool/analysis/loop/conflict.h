/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Which updates decide that a loop is looked at: those of a place that, as far as this shows, two
 * iterations may update. This decides what is looked at, not what may be done: that is proved of
 * each loop by the rest of the analysis.
 */
#ifndef ANALYSIS_CONFLICT_H
#define ANALYSIS_CONFLICT_H

#include "analysis/memory/variable_facts.h"

typedef enum conflict_kind {
    CONFLICT_NONE,    /* each iteration has elements of its own; or the place stays: a sum */
    CONFLICT_REGULAR, /* iterations meet, in a nest of loops with bounds that stay and subscripts
                         that are affine in their counters */
    CONFLICT_SHARED   /* a table, a pointer that is loaded, or a range that changes decides it */
} conflict_kind;

/** Of an lvalue that is updated in the loop. Rows of matrices, a[i * n + j] and a[i][j], count as
 *  the own of iteration i, and so do segments that lie one behind the other, first[i] up to
 * first[i + 1]. */
conflict_kind conflict_of(variable_facts *facts, const ir_node *loop, const ir_node *lvalue);

static inline bool conflict_is_shared(variable_facts *facts, const ir_node *loop,
                                      const ir_node *lvalue) {
    return conflict_of(facts, loop, lvalue) == CONFLICT_SHARED;
}

#endif
