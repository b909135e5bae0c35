/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Recognises atomic operations (__sync_..., __atomic_..., those of <stdatomic.h>), by which
 * programs with threads write updates: `do { old = *x; } while (!__sync_bool_compare_and_swap(x,
 * old, old + v))`. Such an update is not translated; this only serves to report it. */
#ifndef ANALYSIS_ATOMIC_CALL_H
#define ANALYSIS_ATOMIC_CALL_H

#include "ir/ir.h"

/** Advice on a call of the function, if it is an atomic operation that changes memory; otherwise
 *  NULL. */
const char *atomic_advice(const char *name);

/** The name of the atomic operation that the node itself is, if it changes memory; otherwise NULL.
 * A plain atomic store is none: it has no result. */
const char *atomic_name(arena *a, const ir_unit *unit, const ir_node *node);

/** Operand `number` (from 0) of a call or an atomic operation: what it points to, as an lvalue.
 * NULL if there is no such operand, or it is no pointer. */
const ir_node *atomic_pointee(arena *a, const ir_node *node, unsigned number);

#endif
