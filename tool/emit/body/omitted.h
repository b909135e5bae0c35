/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The parts of the user's body that its copy omits: the counter's step, stores that another loop
 *  makes, exits, and dead code. */
#ifndef EMIT_BODY_OMITTED_H
#define EMIT_BODY_OMITTED_H

#include "emit/body/copy.h"

/** Is the statement the counter's step in the body? */
bool is_step(const loop_text *loop, const ir_node *statement);

/** Marks the statements around omitted parts whose bytes cannot be replaced, so that they are
 *  printed without these parts. */
void print_around_omitted(body_copy *copy);

/** Replaces the bytes of the omitted parts that no printed statement contains. */
void drop_omitted(body_copy *copy);

#endif
