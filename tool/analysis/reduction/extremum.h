/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Recognises minima and maxima: if (R < v) R = v, R = v < R ? v : R, R = fmax(R, v) and the
 *  like. */
#ifndef ANALYSIS_EXTREMUM_H
#define ANALYSIS_EXTREMUM_H

#include "analysis/base/facts.h"

typedef struct extremum {
    const ir_node *target; /* the lvalue R; NULL if the node has none of these forms */
    bool has_operator;     /* the value that is compared is also the one that is stored, and `op`
                            * is set */
    reduction_operator op; /* REDUCTION_MINIMUM or REDUCTION_MAXIMUM */
    bool commutes;         /* the order of the updates does not matter, because R and v are integers
                            * of the same type. For floating values the order does matter, because
                            * of NaNs and the sign of zero */
} extremum;

/** Recognises an IR_IF or IR_ASSIGN. For any other node, the result's target is NULL. */
extremum extremum_of(const ir_node *node);

#endif
