/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Slice and body as separate functions, before the user's function.
 *
 * The moved text must keep its meaning: no directive may be between the two places, each name must
 * be declared there or passed, each type must have a name. A variable is passed by value if the
 * loop only reads it and does not use its address; an array as a pointer, if its type and size are
 * not used; any other by its address, if all its uses are known.
 */
#ifndef PLAN_OUTLINE_H
#define PLAN_OUTLINE_H

#include "plan/plan.h"

/** How a moved function gets a variable. */
typedef enum handing {
    NOT_HANDED,        /* not needed: it is declared inside, replaced by a parameter, or visible
                        * there */
    HANDED,            /* by value, as a parameter */
    HANDED_BY_ADDRESS, /* by a pointer that replaces its name */
    CANNOT_BE_HANDED
} handing;

/** For the body, or for the slice. Requires is_shadowed. */
handing handing_of(const loop_plan *plan, const ir_variable *variable, bool of_body);

/** Is the node a string that is, or may be, __func__? */
bool says_function_name(const loop_plan *plan, const ir_node *node);

/** The reason why they cannot be moved, whatever their names; NULL: they can. */
const char *plan_outline(const loop_plan *plan);

#endif
