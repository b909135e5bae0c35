/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Selects the updates that make a loop a candidate: those of elements that two iterations may
 *  update, by a simple criterion. This decides only which loops are analysed; other checks prove
 *  what may be done. */
#ifndef ANALYSIS_CONFLICT_H
#define ANALYSIS_CONFLICT_H

#include "analysis/memory/variable_facts.h"

typedef enum conflict_kind {
    CONFLICT_NONE,    /* each iteration has separate elements, or all iterations have the same few
                       * (sums) */
    CONFLICT_REGULAR, /* two iterations may update the same element, but in a nest of loops with
                       * invariant bounds and with subscripts that are affine in the counters */
    CONFLICT_SHARED   /* a value from a table, a loaded pointer, or a range that varies selects
                       * the element */
} conflict_kind;

/** The whole object if the lvalue is a part of one, such as the complex number z[k] for
 *  `__real__ z[k]`, or a vector. Otherwise the lvalue itself. */
const ir_node *conflict_whole(const ir_node *lvalue);

/** Classifies the update of an lvalue by the node `place`, which is the lvalue itself or a call
 *  whose function updates it. For a part of an object the result is that for the whole object,
 *  whichever parts the iterations update. Rows of matrices, a[i * n + j] and a[i][j], count as
 *  separate for each iteration i. So do consecutive segments, from first[i] to first[i + 1]. */
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
