/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Recognises the compiler's atomic operations (__sync_..., __atomic_...), by which programs with
 *  threads write updates: `do { old = *x; } while (!__sync_bool_compare_and_swap(x, old, old +
 * v))`. Such an update is not translated; this only serves to report it. */
#ifndef ANALYSIS_ATOMIC_CALL_H
#define ANALYSIS_ATOMIC_CALL_H

#include "ir/ir.h"

/** Is it the name of an atomic operation that writes memory? */
bool atomic_is_name(const char *name);

/** The name of an atomic operation that the node is or, for a call of a function with a body, that
 *  the function contains. NULL if there is none. */
const char *atomic_name(arena *a, const ir_node *node);

/** Operand `number` (from 0) of such a node: what it points to, as an lvalue. NULL if there is no
 *  such operand, or it is no pointer. */
const ir_node *atomic_pointee(arena *a, const ir_node *node, unsigned number);

#endif
