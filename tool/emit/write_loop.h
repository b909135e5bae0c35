/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** One loop whole: what stands in its place, and what stands in front of its function. */
#ifndef EMIT_WRITE_LOOP_H
#define EMIT_WRITE_LOOP_H

#include "emit/base/loop.h"

/** A text that replaces bytes of the file, with marks (origin.h). */
typedef struct loop_piece {
    const char *text; /* NULL: there is none */
    ir_range replaced;
} loop_piece;

/** With a body for several iterations at once, with a form for bins, with neither: each is tried
 *  where the one before is not possible. */
typedef enum loop_form { FORM_LANES, FORM_BINNED, FORM_SHORT } loop_form;

/** loop.c: the block of a loop of which arena, unit, facts, options and is_unfused are set, and
 * what goes in front of the function; sets *form to what was possible.
 * False, with the obstacle in *why: it cannot be written. */
bool write_loop(loop_text loop, loop_form *form, loop_piece *front, loop_piece *block, reason *why);

/** The #if around what is there only where the loop may run in parallel; behind what
 *  begin_as_compiled writes. */
const char *loop_condition(const loop_text *loop);

#endif
