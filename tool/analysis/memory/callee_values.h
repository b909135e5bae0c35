/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Expresses values in a function's text by its parameters and the file's objects. Local variables
 *  and changed parameters are replaced by the values that they have at a place. */
#ifndef ANALYSIS_CALLEE_VALUES_H
#define ANALYSIS_CALLEE_VALUES_H

#include "analysis/memory/callee_loops.h"
#include "analysis/memory/callee_terms.h"

typedef struct callee_rewriting {
    const callee_terms *terms;
    const access *item;
    callee_loops *loops; /* the loops around the access; NULL if counters must not occur in the
                          * result */
    const ir_node *site; /* the place of evaluation in the function's text; NULL if the value may
                          * be that of another iteration */
    bool is_exact;
    bool loads_stay;        /* memory that the rewritten expressions load is not written while the
                             * caller's loop runs */
    bool has_load;          /* the address depends on a load */
    bool loads_are_certain; /* whenever the function is called, all loads in the rewritten
                             * expressions happen */
    bool follows_changes;   /* variables that are set several times are replaced by their values
                             * too */
    unsigned depth, nodes;
} callee_rewriting;

/** A copy of an address, or of an operand of one, expressed by the parameters and the file's
 *  objects. Clears is_exact if a part is unknown, may change while the function runs, or names an
 *  object that the caller cannot name. */
ir_node *callee_rewrite(callee_rewriting *r, const ir_node *node);

/** Same as callee_rewrite, for a value. Reading the value counts as a load on which the address
 *  depends. */
ir_node *callee_rewrite_value(callee_rewriting *r, const ir_node *node);

#endif
