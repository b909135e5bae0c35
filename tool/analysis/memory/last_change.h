/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds the statement that last changed a variable before a place in its function. */
#ifndef ANALYSIS_LAST_CHANGE_H
#define ANALYSIS_LAST_CHANGE_H

#include "analysis/memory/variable_facts.h"

typedef struct last_change {
    enum {
        CHANGE_UNKNOWN, /* a loop, a switch, a call or a part of an expression may have changed
                         * it */
        CHANGE_NONE,    /* no change since the beginning of the function or branch */
        CHANGE_SET,     /* `node` is v = e, v op= e, v++, or a declarator with an initialiser */
        CHANGE_IF       /* `node` is an `if`. One of its branches may change the variable; its
                         * condition does not */
    } kind;
    const ir_node *node;
} last_change;

/** The last change before `site`, an evaluated node of the function's text. Changes in earlier
 *  iterations of loops around `site` are CHANGE_UNKNOWN. */
last_change last_change_before(variable_facts *facts, const ir_function *function,
                               const ir_variable *variable, const ir_node *site);

/** The last change in a branch of an `if`, as seen from the branch's end. */
last_change last_change_in(variable_facts *facts, const ir_variable *variable,
                           const ir_node *branch);

#endif
