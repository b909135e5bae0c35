/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Slice and body as functions of their own, in front of the user's function.
 *
 * What is moved there must mean the same: no directive may stand between the two places, each name
 * must be declared there or handed over, each type must have a name. A variable is handed over by
 * value, if the loop only reads it and its address is nothing to it; an array as a pointer, if its
 * type and size are not asked for; any other by its address, if all that names it is seen.
 */
#ifndef PLAN_OUTLINE_H
#define PLAN_OUTLINE_H

#include "plan/plan.h"

/** How a function that is moved gets a variable that it names. */
typedef enum handing {
    NOT_HANDED,        /* it is its own, stood for by a parameter, or seen from there */
    HANDED,            /* as a parameter */
    HANDED_BY_ADDRESS, /* a pointer to it is, and its name is replaced */
    CANNOT_BE_HANDED
} handing;

/** Of the body, or of the slice. is_shadowed is set. */
handing handing_of(const loop_plan *plan, const ir_variable *variable, bool of_body);

/** Is the node a string that is, or may be, __func__? */
bool says_function_name(const loop_plan *plan, const ir_node *node);

/** Why they cannot stand there, whatever they name; NULL: they can. */
const char *plan_outline(const loop_plan *plan);

#endif
