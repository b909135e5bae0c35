/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Analyses the variables that a for loop's header sets before the first iteration: the counter, a
 *  variable with the bound, and others. Only counted.c uses this header. */
#ifndef ANALYSIS_COUNTED_START_H
#define ANALYSIS_COUNTED_START_H

#include "analysis/base/facts.h"

/** Fills in `lower` and the other fields that the initialisation determines.
 *  counted_split_declaration handles a declaration, counted_split_initialisation an expression or
 *  an empty initialisation. `counter`, `bound` and `body` must be set. Both return false if the
 *  initialisation does anything else. */
bool counted_split_declaration(const ir_node *loop, const ir_node *declaration,
                               counted_loop *counted);
bool counted_split_initialisation(const ir_node *loop, const ir_node *node, counted_loop *counted);

#endif
