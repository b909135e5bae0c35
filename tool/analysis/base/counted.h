/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Loops whose number of iterations is known when they begin, and the ranges of inner counters. */
#ifndef ANALYSIS_COUNTED_H
#define ANALYSIS_COUNTED_H

#include "analysis/base/facts.h"

typedef struct counted_result {
    bool is_counted;
    counted_loop loop;
    reason_id why;       /* not counted: what is in the way, */
    const ir_node *node; /* where, */
    const char *name;    /* and its name */
} counted_result;

/** Brings a for or while loop into the form of counted_loop; a do loop is none here. That the
 * bound's memory is not written in the loop is not checked here, that its variables are not is. */
counted_result counted_recognise(ir_node *loop);

/** The same, but that the header may set and step others beside the counter. */
counted_result counted_recognise_beside(ir_node *loop);

/** The same as counted_recognise, with what is left to the caller: the bound may call functions,
 * the counter's address may be taken outside the loop, the header may set a variable to the bound
 * (bound_variable) and step others beside the counter. The step may be no constant (stride), and an
 * unsigned counter may wrap in a way that its value after the loop tells. A do loop may be one
 * whose first value does not meet the condition, or whose counter would never come to the bound: it
 * then iterates other than by counter, bound and step.
 */
counted_result counted_recognise_analysed(ir_node *loop);

/** v++, v += c, v = v + c and the like, with a constant: the variable and the step. */
bool counted_step(const ir_node *node, ir_variable **variable, int64_t *step);

/** Is this a for loop over constants, with at least one iteration? Then its counter takes values
 *  in [*first, *last] (first <= last, whichever way it runs) in the body. */
bool counted_constant(const ir_node *loop, const ir_variable **counter, int64_t *first,
                      int64_t *last);

/** The values an integer expression may have where it stands, from constants and the counters of
 *  the constant loops around it. */
bool counted_range(const ir_node *expression, int64_t *low, int64_t *high);

/** Does anything below `node` assign the variable (or take its address by &)? Opaque nodes are the
 *  caller's to refuse. */
bool variable_is_written_in(const ir_node *node, const ir_variable *variable);

#endif
