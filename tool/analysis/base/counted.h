/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Recognises counted loops, whose trip count is known when they begin, and computes the ranges of
 *  their counters. */
#ifndef ANALYSIS_COUNTED_H
#define ANALYSIS_COUNTED_H

#include "analysis/base/facts.h"

typedef struct counted_result {
    bool is_counted;
    counted_loop loop;
    reason_id why;       /* why the loop is not counted; only set if is_counted is false */
    const ir_node *node; /* the node that the reason concerns */
    const char *name;    /* name for the reason's message; NULL only if the reason is
                          * REASON_TRIP_COUNT and the loop has no counter */
} counted_result;

/** Recognises a for or while loop as a counted_loop; do loops are rejected. Checks that the loop
 *  does not write the variables in the bound, but not whether it writes memory that the bound
 *  reads. */
counted_result counted_recognise(ir_node *loop);

/** Same as counted_recognise, but the header may also set and step variables other than the
 *  counter. */
counted_result counted_recognise_with_others(ir_node *loop);

/** Recognises more loops. The caller must check their additional properties:
 *  - the bound may call functions;
 *  - the counter may be a pointer, have its address taken outside of the loop, and be stepped by
 *    the condition or the body; the condition may be the bare counter;
 *  - the header may set a variable to the bound (bound_variable), and step variables other than the
 *    counter;
 *  - the step need not be constant (stride);
 *  - an unsigned counter may wrap around if its final value shows whether it did (counted_wraps.h);
 *  - in a do loop the first value may fail the condition, or the counter may never reach the bound.
 *    The do loop's iterations then differ from those that counter, bound and step imply. */
counted_result counted_recognise_analysed(ir_node *loop);

/** Is the step the first statement of the loop's body, or any statement of a for loop's body? Only
 *  counted_recognise_analysed recognises such loops. */
bool counted_steps_by_statement(const ir_node *loop, const counted_loop *counted);

/** Is it a step of a variable by a constant: v++, v += c, v = v + c and the like? Stores the
 *  variable and the step. */
bool counted_step(const ir_node *node, ir_variable **variable, int64_t *step);

/** Is this a for loop over constants with at least one iteration? Then *first and *last are the
 *  least and the greatest value of its counter in the body, whichever way it counts. */
bool counted_constant(const ir_node *loop, const ir_variable **counter, int64_t *first,
                      int64_t *last);

/** A loop that counted_constant accepts, with its counter's least and greatest value. */
typedef struct constant_loop {
    const ir_node *loop; /* NULL: there is none */
    int64_t first, last;
} constant_loop;

/** Returns the innermost constant loop that the variable counts, that has `node` in its body, and
 *  that is inside `outermost`, or anywhere if `outermost` is NULL. */
constant_loop counted_constant_around(const ir_node *node, const ir_node *outermost,
                                      const ir_variable *variable);

/** Is the variable named only in constant loops that it counts? Then the value that it has
 *  elsewhere does not matter. */
bool counted_constant_sets(const ir_node *node, const ir_variable *variable);

/** Stores bounds of an integer expression's value at its place, derived from constants and from the
 *  counters of the constant loops around it. Returns false if they are unknown. */
bool counted_range(const ir_node *expression, int64_t *low, int64_t *high);

/** Does `node`, or anything below it, assign the variable or take its address by &? Opaque nodes
 *  are not examined; the caller must reject them. */
bool variable_is_written_in(const ir_node *node, const ir_variable *variable);

#endif
