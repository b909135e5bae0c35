/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Values of a function's text in terms of its parameters and of the file's objects: what its local
 *  variables and changed parameters stand for at a place. */
#ifndef ANALYSIS_CALLEE_VALUES_H
#define ANALYSIS_CALLEE_VALUES_H

#include "analysis/memory/callee_loops.h"
#include "analysis/memory/callee_terms.h"

typedef struct callee_rewriting {
    const callee_terms *terms;
    const access *item;
    callee_loops *loops; /* NULL: counters have no meaning */
    const ir_node *site; /* the place of evaluation in the function's text; NULL: it may be another
                          * iteration's value */
    bool is_exact;
    bool loads_stay;        /* what is read here is not written while the caller's loop runs */
    bool has_load;          /* an address depends on loads */
    bool loads_are_certain; /* all of them are made whenever the function is called */
    bool follows_changes;   /* variables set several times, too, are replaced by their values */
    unsigned depth, nodes;
} callee_rewriting;

/** A copy of an address, or of an operand of one, in these terms; clears is_exact where a part is
 *  unknown. */
ir_node *callee_rewrite(callee_rewriting *r, const ir_node *node);

/** The same for a value: reading it counts as a load on the way to an address. */
ir_node *callee_rewrite_value(callee_rewriting *r, const ir_node *node);

#endif
