/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Expressions that generated code may evaluate although the program does not. */
#ifndef EMIT_BASE_WRAPPING_H
#define EMIT_BASE_WRAPPING_H

#include "analysis/overlap/row_address.h"
#include "emit/base/loop.h"

/** If the node is a signed sum, difference, product, negation or left shift: its text as a primary
 * expression that wraps around on overflow. NULL if it is none of these, is a known constant, or
 * has an operand that cannot be spelled. `rename` and `context` are those of text_operand. */
const char *wrapping_operation(arena *a, const ir_node *node, ir_c_rename rename, void *context);

/** Returns the address as a number of type redcc_size, or NULL if it cannot be spelled. `counter`:
 * the counter of a span (an inner loop that is logged as one range), or NULL. A subscript that
 * increases with `counter` is computed in 64 bits. */
const char *address_number(arena *a, const row_address *address, const ir_variable *counter,
                           ir_c_rename rename, void *context);

#endif
