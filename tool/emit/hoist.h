/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What is read before the first iteration. */
#ifndef EMIT_HOIST_H
#define EMIT_HOIST_H

#include "emit/loop.h"

/** hoist.c: records an obstacle where something that must be evaluated before the first iteration
 *  is not certain to be evaluated by the loop itself. */
void check_what_is_read_ahead(loop_text *loop);
/** Is this pointer or array valid as soon as the loop is known to iterate? */
bool can_be_read_ahead(const loop_facts *facts, const ir_node *base);

#endif
