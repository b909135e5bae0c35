/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The variables that replace an iteration's own elements (analysis/loop/own.h). */
#ifndef EMIT_BASE_OWN_H
#define EMIT_BASE_OWN_H

#include "emit/base/loop.h"

/** The variable that replaces this node, or NULL. */
const char *own_name(const loop_text *loop, const ir_node *node);
/** Declares the variables: those of the slice (`of_slice`), or all. They begin with the elements'
 * values, or with 0 if the iteration stores first. `rename` spells the elements. */
void declare_own(loop_text *loop, writer *out, bool of_slice, ir_c_rename rename, void *context);

#endif
