/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Writes one loop: the text that replaces it, and the text before its function. */
#ifndef EMIT_WRITE_LOOP_H
#define EMIT_WRITE_LOOP_H

#include "emit/base/loop.h"

/** A text that replaces bytes of the file, with marks (origin.h). */
typedef struct loop_piece {
    const char *text; /* NULL: there is none */
    ir_range replaced;
} loop_piece;

/** The forms in which a loop may be written, in the order in which they are tried: with a function
 *  for several iterations at once (lanes); for in-order binning; with neither of these. */
typedef enum loop_form { FORM_LANES, FORM_BINNED, FORM_SHORT } loop_form;

/** Writes the block that replaces the loop, and the text before its function. Sets *form to the
 * form used. Returns false, with the obstacle in *why, if the loop cannot be written. These fields
 * of `loop` must be set: arena, whole, unit, facts, plan, options, is_unfused and lanes.outcome. */
bool write_loop(loop_text loop, loop_form *form, loop_piece *front, loop_piece *block, reason *why);

/** Returns the #if under which the loop may run in parallel. In the output it follows the text of
 *  begin_as_compiled. */
const char *loop_condition(const loop_text *loop);

#endif
