/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Slice and body as separate functions, before the user's function.
 *
 * The moved text must keep its meaning. No directive may be between the two places, each name must
 * be declared at the new place or passed, and each type must have a name. A variable of the user's
 * function is passed by value if it is a scalar or a small struct that the loop only reads. An
 * array is passed as a pointer if its type and size are not used. Any other variable is passed by
 * its address.
 */
#ifndef PLAN_OUTLINE_H
#define PLAN_OUTLINE_H

#include "plan/plan.h"

/** How a moved function gets a variable. */
typedef enum passing {
    NOT_PASSED,        /* not needed: the variable is declared inside, replaced by a parameter, or
                        * visible to the moved function */
    PASSED_BY_VALUE,   /* by value, as a parameter */
    PASSED_BY_ADDRESS, /* by a pointer that replaces its name */
    CANNOT_BE_PASSED
} passing;

/** How the body (`of_body`) or the slice gets the variable. Requires is_shadowed. */
passing passing_of(const loop_plan *plan, const ir_variable *variable, bool of_body);

/** Is the node a string that is, or may be, __func__? */
bool says_function_name(const loop_plan *plan, const ir_node *node);

/** The reason why slice and body cannot be moved, or NULL if they can. */
const char *plan_outline(const loop_plan *plan);

#endif
