/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The statement that gave a variable the value it has at a place of its function. */
#ifndef ANALYSIS_LAST_CHANGE_H
#define ANALYSIS_LAST_CHANGE_H

#include "analysis/memory/variable_facts.h"

typedef struct last_change {
    enum {
        CHANGE_UNKNOWN, /* by a loop, a switch, a call, a part of an expression */
        CHANGE_NONE,    /* none since the function, or the branch, began */
        CHANGE_SET,     /* node: v = e, v op= e, v++, or a declarator with a value */
        CHANGE_IF       /* node: an `if`, a branch of which may change it; its condition does not */
    } kind;
    const ir_node *node;
} last_change;

/** The last change before `site`, a node of the function's text that is evaluated, in the same
 *  iteration of every loop around it. */
last_change last_change_before(variable_facts *facts, const ir_function *function,
                               const ir_variable *variable, const ir_node *site);

/** The last change in a branch of an `if`, where it ends normally. */
last_change last_change_in(variable_facts *facts, const ir_variable *variable,
                           const ir_node *branch);

#endif
