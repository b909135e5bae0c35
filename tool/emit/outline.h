/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Slice and body as functions in front of the user's function. */
#ifndef EMIT_OUTLINE_H
#define EMIT_OUTLINE_H

#include "emit/loop.h"

/** outline.c: slice and body as functions, to be inserted at *place, and sets is_outlined and the
 *  calls; NULL: the loop is to be written in place. */
const char *write_outlined(loop_text *loop, uint32_t *place);
/** The name of something in front of the function: "redcc__slice_springs_15". */
const char *outlined_name(loop_text *loop, const char *part);
/** The declaration of a private variable in one of these functions. */
const char *outlined_declaration(loop_text *loop, const ir_variable *variable);

/** outline.c: what the name of that function ends with. */
const char *loop_lanes_name(loop_text *loop);

#endif
