/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The change of an expression from one iteration of a loop to the next. */
#ifndef ANALYSIS_VARIATION_H
#define ANALYSIS_VARIATION_H

#include "analysis/memory/variable_facts.h"

/** No variable in it is assigned in the loop, and it calls nothing. The caller must check the
 *  memory that it reads. */
bool variation_is_invariant(variable_facts *facts, const ir_node *loop, const ir_node *expression);

/** The same for an lvalue's address: its contents may change. */
bool variation_is_fixed(variable_facts *facts, const ir_node *loop, const ir_node *lvalue);

typedef struct affine_form {
    bool is_affine; /* multiple * counter + an invariant */
    bool is_known;  /* `multiple` is a constant */
    int64_t multiple;
} affine_form;

/** The expression as an affine form of the loop's own counter; looks through no definitions. The
 *  mathematical value is affine: C's equals it only if no operation wraps around (exact.h). */
affine_form variation_affine(variable_facts *facts, const ir_node *loop, const ir_variable *counter,
                             const ir_node *expression);

/** Is this lvalue an array element found through a subscript that is not affine in the counters of
 *  the loop and of inner ones, or through a counter that begins at an element so found? Looks
 *  through local variables assigned once. */
bool variation_is_irregular(variable_facts *facts, const ir_node *loop, const ir_node *lvalue);

#endif
