/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Determines how an expression changes from one iteration of a loop to the next. */
#ifndef ANALYSIS_VARIATION_H
#define ANALYSIS_VARIATION_H

#include "analysis/memory/variable_facts.h"

/** Is the expression invariant: does the loop assign no variable in it, and does it call nothing?
 *  Memory that it reads must be checked by the caller. */
bool variation_is_invariant(variable_facts *facts, const ir_node *loop, const ir_node *expression);

/** Is the address of the lvalue invariant? Its contents may change. */
bool variation_is_fixed(variable_facts *facts, const ir_node *loop, const ir_node *lvalue);

typedef struct affine_form {
    bool is_affine; /* the expression is multiple * counter + invariant */
    bool is_known;  /* `multiple` is a constant */
    int64_t multiple;
} affine_form;

/** The expression as an affine form of the loop's own counter. Variables are not replaced by their
 *  definitions. Only the mathematical value is affine; C's value equals it if no operation wraps
 *  around (exact.h). */
affine_form variation_affine(variable_facts *facts, const ir_node *loop, const ir_variable *counter,
                             const ir_node *expression);

/** Is the lvalue an array element whose subscript is irregular? A subscript is irregular if it is
 *  not affine in the counters of the loop and inner loops. So is a counter whose first value is
 *  found through such a subscript. Local variables that are assigned once are replaced by their
 *  values. */
bool variation_is_irregular(variable_facts *facts, const ir_node *loop, const ir_node *lvalue);

#endif
