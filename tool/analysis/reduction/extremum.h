/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The spellings of a minimum and a maximum: if (R < v) R = v, R = v < R ? v : R, R = fmax(R, v).
 */
#ifndef ANALYSIS_EXTREMUM_H
#define ANALYSIS_EXTREMUM_H

#include "analysis/base/facts.h"

typedef struct extremum {
    const ir_node *target; /* NULL: the node has none of these forms */
    bool has_operator;     /* the compared value is the stored one; `op` is set */
    reduction_operator op; /* REDUCTION_MINIMUM or REDUCTION_MAXIMUM */
    bool commutes;         /* integers of one type: the order of the updates does not matter. For
                            * floating values it does, because of NaNs and the sign of zeros */
} extremum;

/** Recognises an IR_IF or IR_ASSIGN; any other node has no target. */
extremum extremum_of(const ir_node *node);

#endif
