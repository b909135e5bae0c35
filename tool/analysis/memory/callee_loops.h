/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The counted loops of a function around a place in it, and what is certain to be evaluated there.
 */
#ifndef ANALYSIS_CALLEE_LOOPS_H
#define ANALYSIS_CALLEE_LOOPS_H

#include "analysis/base/counted.h"

enum { CALLEE_MOST_LOOPS = 4 };

typedef struct callee_loop {
    const ir_node *loop; /* a for */
    counted_loop counted;
    bool is_constant;   /* at least one iteration, over constants */
    bool may_end_early; /* by break, return or goto */
    bool is_used;       /* set by callee_loops_counter */
} callee_loop;

typedef struct callee_loops {
    const ir_node *body; /* of the function */
    unsigned count;      /* outermost first; loops that are not counted are none of them */
    callee_loop items[CALLEE_MOST_LOOPS];
    bool are_known; /* false: more than these, or jumps that are not followed */
} callee_loops;

callee_loops callee_loops_around(const ir_function *function, const ir_node *node);

/** Is the variable, where `site` evaluates it, the counter of one of these loops? Notes that it is
 *  asked for. */
bool callee_loops_counter(callee_loops *loops, const ir_variable *variable, const ir_node *site);

/** Is the node evaluated whenever the function is called, for each value of the counters of those
 * of these loops that are around it? (Of a loop: its header, to begin with.) */
bool callee_loops_is_certain(const callee_loops *loops, const ir_node *node);

/** Is the variable the counter of one of these loops that is around both nodes, so that it has the
 *  same values there? */
bool callee_loops_share(const callee_loops *loops, const ir_variable *variable,
                        const ir_node *first, const ir_node *second);

/** A value that `place`, a declarator or assignment, gives to a variable: is that the one that
 *  `site` finds, in each iteration of the loops around it? */
bool callee_loops_is_set_before(const ir_node *place, const ir_node *site);

#endif
