/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Hulls (analysis/loop/hulls.h): the hull of a loop's accesses is the range from the lowest to the
 * highest address. While a thread classifies iterations, some loops of the slice visit only their
 * first and last iterations. This file's functions write the macros around and inside such
 * loops. */
#ifndef EMIT_SLICE_HULL_H
#define EMIT_SLICE_HULL_H

#include "emit/slice/access_log.h"

/** Does the slice load memory after an update in the inner loop, so that the update might change
 * it? If the loop needs a dry run, each update must be logged before the next load. The slice then
 *  repeats such an inner loop iteration by iteration, instead of logging its rows at once. */
bool loads_between_updates(const loop_text *loop, const ir_node *inner);

/** Is the loop the outermost of the loops that visit only their first and last iterations? */
bool begins_hulls(const inspector *self, const ir_node *loop);

/** begin_hulls writes the declarations before `loop`. end_hulls writes, after the loop, the
 * comparisons of the hulls with the owner's range. */
void begin_hulls(inspector *self, const ir_node *loop);
void end_hulls(inspector *self);

/** Returns the loop's step expression if the loop visits only its first and last iterations.
 * Returns NULL if it keeps the program's own step. */
const char *hull_step(inspector *self, const ir_node *loop);

#endif
