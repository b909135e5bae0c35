/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The backward slice: which statements and control of a loop's body compute the addresses that the
 * inspector tells.
 */
#ifndef ANALYSIS_SLICE_H
#define ANALYSIS_SLICE_H

#include "analysis/analyser.h"

/** An address to be told before a statement. */
typedef struct slice_touch {
    const ir_node *row;
    unsigned loop_count; /* as of loop_source */
    const source_loop *loops;
    const ir_node *place;
} slice_touch;

typedef struct slice {
    bool *keep;            /* [function->node_count] */
    unsigned needed_count; /* variables of the iteration whose values it asks for */
    const ir_variable **needed;
    bool has_floating_work;
    const ir_node *obstacle; /* why there is none; NULL: there is one */
} slice;

/** The slice of all touches together. */
slice slice_compute(const judgement *j, unsigned touch_count, const slice_touch *touches);

/** Can the addresses of the source's row, with its loops, be computed before `place`, however control
 *  gets there: nothing in them is assigned in the statement itself, and no condition inside it
 *  protects a load of theirs? */
bool slice_can_tell(const judgement *j, const loop_source *told, const ir_node *node,
                    const ir_node *place);

/** The statement or declarator of the body around `node`; NULL: it stands in the loop's header. */
const ir_node *slice_place(const judgement *j, const ir_node *node);

/** Does a condition within the statement `place` decide whether it comes to `node`? */
bool slice_is_ahead(const ir_node *node, const ir_node *place);

/** May this expression be evaluated where the program did not: no loads, no calls, nothing that may
 *  trap or have no meaning (divisions, conversions of floating values, shifts)? Overflow of signed
 *  sums and products is left to who writes it: emit/unconditional.c. */
bool slice_is_safe_anywhere(const ir_node *row);

/** Has each of the loops bounds that are constants? */
bool slice_loops_are_constant(unsigned count, const source_loop *loops);

/** The same, in the loop: loads are allowed that each iteration makes in any case. `as_address`:
 *  of an lvalue only the address is computed. */
bool slice_is_safe_here(const judgement *j, const ir_node *node, bool as_address);

#endif
