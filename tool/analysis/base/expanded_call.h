/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Expands a call like a macro. `force(&p[i], &p[j]);` becomes the block
 *
 *     { double d = p[i].x - p[j].x; if (d > 2) { } else { p[i].f += d; p[j].f -= d; } }
 *
 * All nodes of the block have the call's range, like the nodes of an expanded macro: generated code
 * prints them instead of copying text. The user's text keeps the call, also in the sequential form.
 *
 * `int e = force(...);` becomes a declaration of the result, the block and `int e = result;`.
 *
 * An argument whose value cannot change during the call replaces its parameter. Other parameters
 * become variables, and the function's local variables are renamed. The statements after a
 * conditional `return` become its `else` (returns.h).
 */
#ifndef ANALYSIS_EXPANDED_CALL_H
#define ANALYSIS_EXPANDED_CALL_H

#include "ir/ir.h"

/** A statement and the block that replaces it. */
typedef struct expanded_call {
    ir_function *caller;
    ir_node *statement; /* the statement with the call (call_in_statement, expandable_call.h) */
    ir_node *block;     /* its `function` is the called one */
    ir_node **siblings; /* the statements around a declaration with a call; NULL if the statement is
                         * no declaration */
} expanded_call;

/** Replaces a statement with an expandable call by the block, and adds the block's variables to the
 *  unit. The caller's nodes get new numbers. */
expanded_call expanded_call_take_in(ir_unit *unit, ir_function *caller, ir_node *statement);
/** Puts the statement back. Later replacements must be put back before earlier ones. */
void expanded_call_put_back(const expanded_call *call);

#endif
