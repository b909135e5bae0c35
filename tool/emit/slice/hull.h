/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Loops of the slice that visit only their first and last iterations while a thread classifies
 *  iterations (analysis/loop/hulls.h): the macros around and inside of them. */
#ifndef EMIT_SLICE_HULL_H
#define EMIT_SLICE_HULL_H

#include "emit/slice/access_log.h"

/** Does the slice load memory after an update in the inner loop, which the update might change? A
 * loop that needs a dry run logs each update before it makes the next load, so it repeats such an
 * inner loop as the program does, not at once. */
bool loads_between_updates(const loop_text *loop, const ir_node *inner);

/** Is the loop the outermost of such loops? */
bool begins_hulls(const inspector *self, const ir_node *loop);

/** Writes the declarations before this loop, and after it the comparisons of the hulls with the
 *  owner's range. */
void begin_hulls(inspector *self, const ir_node *loop);
void end_hulls(inspector *self);

/** The loop's step expression, while such loops are written; NULL: the program's own. */
const char *hull_step(inspector *self, const ir_node *loop);

#endif
