/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The variables that replace an iteration's own elements: those that no other iteration touches
 * (analysis/loop/own.h). */
#ifndef EMIT_BASE_OWN_H
#define EMIT_BASE_OWN_H

#include "emit/base/loop.h"

/** The variable that replaces this node, or NULL. */
const char *own_name(const loop_text *loop, const ir_node *node);
/** Declares the variables that replace own elements: only those that the slice uses (`of_slice`),
 * or all of them. Their initial values are the elements' values, or 0 if the iteration stores
 * before it reads. `rename` spells the elements. */
void declare_own(loop_text *loop, writer *out, bool of_slice, ir_c_rename rename, void *context);

#endif
