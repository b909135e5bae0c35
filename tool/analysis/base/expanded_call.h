/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A call as if its function were a macro. `force(&p[i], &p[j]);` becomes the block
 *
 *     { double d = p[i].x - p[j].x; if (d > 2) { } else { p[i].f += d; p[j].f -= d; } }
 *
 * All of its nodes have the call's range, as those of a macro have: they are printed, not copied.
 * The user's text keeps the call, also in the sequential form.
 *
 * An argument whose value cannot change during the call stands for its parameter; other parameters
 * become variables. The function's local variables get names of their own. What follows a
 * conditional `return` becomes its `else`.
 */
#ifndef ANALYSIS_EXPANDED_CALL_H
#define ANALYSIS_EXPANDED_CALL_H

#include "ir/ir.h"

/** An exchange of a statement for a block. */
typedef struct expanded_call {
    ir_function *caller;
    ir_node *statement; /* IR_EXPRESSION: the call, or an assignment to a variable that only its
                         * name can reach, with the call as a part of the value */
    ir_node *block;
} expanded_call;

/** For a statement with an expandable call: adds the block's variables to the unit, and exchanges
 * the statement for the block. Numbers the caller's nodes again. */
expanded_call expanded_call_take_in(ir_unit *unit, ir_function *caller, ir_node *statement);
/** The last exchange that is still made must be taken back first. */
void expanded_call_put_back(const expanded_call *call);

#endif
