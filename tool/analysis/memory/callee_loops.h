/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds the counted loops of a function around a place in it, and decides which expressions are
 *  certain to be evaluated there. */
#ifndef ANALYSIS_CALLEE_LOOPS_H
#define ANALYSIS_CALLEE_LOOPS_H

#include "analysis/base/counted.h"
#include "analysis/memory/variable_facts.h"
#include "support/map.h"

enum { CALLEE_MOST_LOOPS = 4 };

typedef struct callee_loop {
    const ir_node *loop; /* an IR_FOR */
    counted_loop counted;
    bool is_constant;   /* it is over constants and has at least one iteration */
    bool may_end_early; /* by break, return or goto */
    bool is_used;       /* set by callee_loops_counter */
} callee_loop;

typedef struct callee_loops {
    const ir_node *body; /* body of the function */
    unsigned count;      /* number of `items`, the outermost loop first. Loops without a recognised
                          * counter are left out */
    callee_loop items[CALLEE_MOST_LOOPS];
    bool are_known; /* false if there are too many loops, or jumps that are not analysed */
} callee_loops;

/** `found` is what earlier calls for this function found, by the innermost loop. The header of a
 *  loop is read once, and not again for each access in the loop. */
callee_loops callee_loops_around(arena *a, variable_facts *facts, map *found,
                                 const ir_function *function, const ir_node *node);

/** Is the variable, as evaluated at `site`, the counter of one of these loops? If so, marks the
 *  loop as used. */
bool callee_loops_counter(callee_loops *loops, const ir_variable *variable, const ir_node *site);

/** Is the node evaluated in every call of the function, for each value of the counters of these
 *  loops around it? For a loop, this concerns the first evaluation of its header. */
bool callee_loops_is_certain(const callee_loops *loops, const ir_node *node);

/** Is the variable the counter of one of these loops that contains both nodes, so that it has the
 *  same values at both? */
bool callee_loops_share(const callee_loops *loops, const ir_variable *variable,
                        const ir_node *first, const ir_node *second);

/** Does the declarator or assignment `place` give the variable the value that it has at `site`, in
 *  each iteration of the loops around it? The variable must not be written elsewhere. */
bool callee_loops_is_set_before(const ir_node *place, const ir_node *site);

#endif
