/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** One whole loop: the text that replaces it, and the text before its function. */
#ifndef EMIT_WRITE_LOOP_H
#define EMIT_WRITE_LOOP_H

#include "emit/base/loop.h"

/** A text that replaces bytes of the file, with marks (origin.h). */
typedef struct loop_piece {
    const char *text; /* NULL: there is none */
    ir_range replaced;
} loop_piece;

/** With a body for several iterations at once, with a form for bins, with neither: each is tried if
 *  the preceding one is not possible. */
typedef enum loop_form { FORM_LANES, FORM_BINNED, FORM_SHORT } loop_form;

/** loop.c: the block of a loop with arena, unit, facts, options and is_unfused set, and the text
 *  before the function; sets *form to the form used. False, with the obstacle in *why: it cannot be
 *  written. */
bool write_loop(loop_text loop, loop_form *form, loop_piece *front, loop_piece *block, reason *why);

/** The #if around the text that exists only if the loop may run in parallel; after the text of
 *  begin_as_compiled. */
const char *loop_condition(const loop_text *loop);

#endif
