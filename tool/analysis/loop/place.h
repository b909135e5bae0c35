/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Places in a loop's body, and expressions that may be computed at another place than in the
 *  program. */
#ifndef ANALYSIS_PLACE_H
#define ANALYSIS_PLACE_H

#include "analysis/loop/loop_analysis.h"

/** Can the addresses of `recorded->row`, for all iterations of `recorded->loops`, be computed
 *  before the statement `place` that contains the read `node`? The statement must assign none of
 *  their operands, and no condition inside it may protect one of their loads. */
bool slice_can_record(const loop_analysis *j, const loop_source *recorded, const ir_node *node,
                      const ir_node *place);

/** The statement or declarator of the body that contains `node`: the whole statement if it is an
 *  update, and the whole `for` if its header declares. NULL if `node` is in the loop's header. */
const ir_node *slice_place(const loop_analysis *j, const ir_node *node);

/** Does a condition inside the statement `place` decide whether `node` is executed? */
bool slice_is_ahead(const ir_node *node, const ir_node *place);

/** May the expression be evaluated where the program does not evaluate it? It must contain no
 *  loads, no calls and no operation that may trap or be undefined (expression_is_hazard). Overflow
 *  of signed sums and products is left to code generation: emit/base/wrapping.c. */
bool slice_is_safe_anywhere(const ir_node *row);

/** Are all bounds of the loops constant? */
bool slice_loops_are_constant(unsigned count, const source_loop *loops);

/** Same as slice_is_safe_anywhere, for evaluation inside the loop. Loads are permitted if each
 *  iteration makes them anyway, or reads the object that they are in. If `as_address` is set, only
 *  the lvalue's address is computed. */
bool slice_is_safe_here(const loop_analysis *j, const ir_node *node, bool as_address);

#endif
