/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Steps that are known when the loop begins, but are no constants: `j += stride`. */
#ifndef ANALYSIS_COUNTED_STRIDE_H
#define ANALYSIS_COUNTED_STRIDE_H

#include "analysis/base/facts.h"

/** v += e, v -= e, v = v + e and the like: e, where it is an integer of numbers and of local
 * variables of the function that nothing but its text can change, and `loop` does not. Evaluating
 * it has no effect then, and one value in all iterations. *is_down: it is subtracted. NULL: `write`
 * is something else. */
const ir_node *stride_added(const ir_node *loop, const ir_node *write, const ir_variable *v,
                            bool *is_down);

/** Fills in counter, step (1 or -1) and stride of `counted` by an increment that is such a one of
 * an integer. That the stride is positive, generated code sees. */
bool counted_split_stride(const ir_node *loop, const ir_node *increment, counted_loop *counted);

#endif
