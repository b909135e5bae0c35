/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The counted loops of a function around a place in it, and expressions that are certain to be
 *  evaluated there. */
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
    unsigned count;      /* outermost first; excludes loops that are not counted */
    callee_loop items[CALLEE_MOST_LOOPS];
    bool are_known; /* false: too many, or jumps that are not followed */
} callee_loops;

callee_loops callee_loops_around(const ir_function *function, const ir_node *node);

/** Is the variable, as evaluated at `site`, the counter of one of these loops? Marks it as used. */
bool callee_loops_counter(callee_loops *loops, const ir_variable *variable, const ir_node *site);

/** Is the node evaluated whenever the function is called, for each value of the counters of these
 *  loops around it? (For a loop: its header, initially.) */
bool callee_loops_is_certain(const callee_loops *loops, const ir_node *node);

/** Is the variable the counter of one of these loops that contains both nodes, so that it has the
 *  same values there? */
bool callee_loops_share(const callee_loops *loops, const ir_variable *variable,
                        const ir_node *first, const ir_node *second);

/** Is the value that `place`, a declarator or assignment, gives to a variable the one at `site`, in
 *  each iteration of the loops around it? */
bool callee_loops_is_set_before(const ir_node *place, const ir_node *site);

#endif
