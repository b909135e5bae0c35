/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Places in the body of a loop, and expressions that may be computed at another place. */
#ifndef ANALYSIS_PLACE_H
#define ANALYSIS_PLACE_H

#include "analysis/loop/loop_analysis.h"

/** Can the addresses of the source's row, with its loops, be computed before `place`? That holds
 *  for any control flow to it if the statement itself assigns none of their operands, and no
 *  condition inside of it protects one of their loads. */
bool slice_can_record(const loop_analysis *j, const loop_source *recorded, const ir_node *node,
                      const ir_node *place);

/** The statement or declarator of the body around `node`; NULL: it is in the loop's header. */
const ir_node *slice_place(const loop_analysis *j, const ir_node *node);

/** Does a condition within the statement `place` decide whether `node` is executed? */
bool slice_is_ahead(const ir_node *node, const ir_node *place);

/** May this expression be evaluated when the program does not: no loads, no calls, no operation
 *  that may trap or be undefined (expression_is_hazard)? Overflow of signed sums and products is
 * left to code generation: emit/base/wrapping.c. */
bool slice_is_safe_anywhere(const ir_node *row);

/** Are all bounds of the loops constants? */
bool slice_loops_are_constant(unsigned count, const source_loop *loops);

/** As slice_is_safe_anywhere, but within the loop: permits a load that each iteration also makes,
 * or whose object it reads, unconditionally. `as_address`: only the lvalue's address is computed.
 */
bool slice_is_safe_here(const loop_analysis *j, const ir_node *node, bool as_address);

#endif
