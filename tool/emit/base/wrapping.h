/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Expressions that may be evaluated when the program does not. */
#ifndef EMIT_BASE_WRAPPING_H
#define EMIT_BASE_WRAPPING_H

#include "analysis/overlap/row_address.h"
#include "emit/base/loop.h"

/** A signed sum, product or shift as one that wraps around: a primary expression. NULL: the node is
 *  none of these. `rename` and its context as in ir_c_expression. */
const char *wrapping_operation(arena *a, const ir_node *node, ir_c_rename rename, void *context);

/** The address as a number, redcc_size. `counter`: one of its subscripts increases with it (spans),
 *  and is computed in 64 bits, as if its type were as wide; or NULL. NULL: cannot be spelled. */
const char *address_number(arena *a, const row_address *address, const ir_variable *counter,
                           ir_c_rename rename, void *context);

#endif
