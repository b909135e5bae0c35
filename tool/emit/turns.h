/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Turns of inner loops that are not the thread's part. */
#ifndef EMIT_TURNS_H
#define EMIT_TURNS_H

#include "emit/loop.h"

/** turns.c: what asks, in the body of an inner loop and in front of statement *before, whether any
 *  row that the rest of the turn updates is the thread's: if not, it goes on to the next turn.
 *  NULL: nothing is to be left out so. */
const char *turn_question(loop_text *loop, const ir_node *inner, ir_c_rename name,
                          const ir_node **before);

#endif
