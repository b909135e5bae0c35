/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Selects the updates that make a loop a candidate: those of an element that two iterations may
 * update, by a simple criterion. This decides only which loops are analysed; other checks prove
 * what may be done.
 */
#ifndef ANALYSIS_CONFLICT_H
#define ANALYSIS_CONFLICT_H

#include "analysis/memory/variable_facts.h"

typedef enum conflict_kind {
    CONFLICT_NONE,    /* each iteration has separate elements, or all have the same few: sums */
    CONFLICT_REGULAR, /* iterations may update one element, in a nest of loops with invariant bounds
                       * and subscripts that are affine in their counters */
    CONFLICT_SHARED   /* a table, a loaded pointer, or a variable range selects the element */
} conflict_kind;

/** The number, vector or other object that the lvalue is a part of, as in `__real__ z[k]`; the
 *  lvalue itself if it is no such part. */
const ir_node *conflict_whole(const ir_node *lvalue);

/** For an lvalue that is updated in the loop by the node at `place`: the lvalue itself, or a call
 *  whose function updates it. Of a part of an object, the conflict of the whole, whichever parts
 *  the iterations update. Rows of matrices, a[i * n + j] and a[i][j], count as
 *  separate for each iteration i, and so do consecutive segments, first[i] up to first[i + 1]. */
conflict_kind conflict_at(variable_facts *facts, const ir_node *loop, const ir_node *lvalue,
                          const ir_node *place);

static inline conflict_kind conflict_of(variable_facts *facts, const ir_node *loop,
                                        const ir_node *lvalue) {
    return conflict_at(facts, loop, lvalue, lvalue);
}

static inline bool conflict_is_shared(variable_facts *facts, const ir_node *loop,
                                      const ir_node *lvalue) {
    return conflict_of(facts, loop, lvalue) == CONFLICT_SHARED;
}

#endif
