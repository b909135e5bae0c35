/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Loops whose trip count is known when they begin, and the ranges of inner counters. */
#ifndef ANALYSIS_COUNTED_H
#define ANALYSIS_COUNTED_H

#include "analysis/base/facts.h"

typedef struct counted_result {
    bool is_counted;
    counted_loop loop;
    reason_id why;       /* if not counted: the reason */
    const ir_node *node; /* place of the reason */
    const char *name;    /* name in the reason's message. NULL, in REASON_TRIP_COUNT only: the loop
                          * has no counter */
} counted_result;

/** Brings a for or while loop into the form of counted_loop; rejects do loops. Checks that the
 *  bound's variables are not written in the loop, but not the memory that the bound reads. */
counted_result counted_recognise(ir_node *loop);

/** The same, but the header may set and step variables other than the counter. */
counted_result counted_recognise_with_others(ir_node *loop);

/** Accepts more loops; the caller must check their additional properties. The bound may call
 *  functions. The counter may be a pointer, have its address taken outside of the loop, and be
 *  stepped by the condition or the body. The header may set a variable to the bound
 *  (bound_variable) and step others besides the counter. The step need not be constant (stride); an
 *  unsigned counter may wrap around if its final value shows it. A do loop's first value may fail
 *  the condition, or its counter never reach the bound: its iterations then differ from those given
 *  by counter, bound and step. */
counted_result counted_recognise_analysed(ir_node *loop);

/** v++, v += c, v = v + c and the like, with a constant: the variable and the step. */
bool counted_step(const ir_node *node, ir_variable **variable, int64_t *step);

/** Is this a for loop over constants, with at least one iteration? Then its counter takes values in
 *  [*first, *last] in the body (first <= last, in either direction). */
bool counted_constant(const ir_node *loop, const ir_variable **counter, int64_t *first,
                      int64_t *last);

/** Is the variable named only in loops over constants that count with it? Then its value elsewhere
 *  does not matter. */
bool counted_constant_sets(const ir_node *node, const ir_variable *variable);

/** The possible values of an integer expression at its place, from constants and the counters of
 *  the constant loops around it. */
bool counted_range(const ir_node *expression, int64_t *low, int64_t *high);

/** Does anything below `node` assign the variable (or take its address by &)? The caller must
 *  refuse opaque nodes. */
bool variable_is_written_in(const ir_node *node, const ir_variable *variable);

#endif
