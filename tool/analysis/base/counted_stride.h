/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Recognises steps that are known when the loop begins but are not constant: `j += stride`. */
#ifndef ANALYSIS_COUNTED_STRIDE_H
#define ANALYSIS_COUNTED_STRIDE_H

#include "analysis/base/facts.h"

/** Is `node` an integer expression of numbers and of local variables whose address is not taken
 *  and that `loop` does not change? If so, its evaluation has no effect and gives the same value in
 *  all iterations. */
bool stride_is_steady(const ir_node *loop, const ir_node *node);

/** The same for variables that may also change through their addresses, which the caller must
 *  check. */
bool stride_is_unwritten(const ir_node *loop, const ir_node *node);

/** Is the write of the form v += e, v -= e, v = v + e or the like? Returns e, and sets *is_down if
 *  e is subtracted. Otherwise returns NULL. */
const ir_node *stride_added(const ir_node *write, const ir_variable *v, bool *is_down);

/** Fills in counter, step (1 or -1) and stride of `counted` from a header's increment of an integer
 *  counter by a steady expression (stride_added). Returns false if `increment` has another form.
 *  Generated code checks that the stride is positive. */
bool counted_split_stride(const ir_node *loop, const ir_node *increment, counted_loop *counted);

#endif
