/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Places in the body of a loop, and what may be computed at another one than where it stands. */
#ifndef ANALYSIS_PLACE_H
#define ANALYSIS_PLACE_H

#include "analysis/loop/loop_analysis.h"

/** Can the addresses of the source's row, with its loops, be computed before `place`, however
 * control gets there: nothing in them is assigned in the statement itself, and no condition inside
 * it protects a load of theirs? */
bool slice_can_tell(const loop_analysis *j, const loop_source *told, const ir_node *node,
                    const ir_node *place);

/** The statement or declarator of the body around `node`; NULL: it stands in the loop's header. */
const ir_node *slice_place(const loop_analysis *j, const ir_node *node);

/** Does a condition within the statement `place` decide whether it comes to `node`? */
bool slice_is_ahead(const ir_node *node, const ir_node *place);

/** May this expression be evaluated where the program did not: no loads, no calls, nothing that may
 *  trap or have no meaning (divisions, conversions of floating values, shifts)? Overflow of signed
 *  sums and products is left to who writes it: emit/base/wrapping.c. */
bool slice_is_safe_anywhere(const ir_node *row);

/** Has each of the loops bounds that are constants? */
bool slice_loops_are_constant(unsigned count, const source_loop *loops);

/** The same, in the loop: loads are allowed that each iteration makes in any case. `as_address`:
 *  of an lvalue only the address is computed. */
bool slice_is_safe_here(const loop_analysis *j, const ir_node *node, bool as_address);

#endif
