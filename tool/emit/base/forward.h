/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Elements that an iteration stores and reads again. */
#ifndef EMIT_BASE_FORWARD_H
#define EMIT_BASE_FORWARD_H

#include "emit/base/loop.h"

/** Declares the variables, those of the slice only or all. */
void declare_forwards(loop_text *loop, writer *out, bool of_slice);
/** The variable that replaces a read of this node, or NULL. */
const char *forward_read_name(const loop_text *loop, const ir_node *node);
/** Assigns the stored value to the variable, and that to the element, in a separate statement. */
void write_forward(loop_text *loop, writer *out, const forwarded_store *store, ir_c_rename rename,
                   void *context);
void write_forwarded_store(loop_text *loop, writer *out, const forwarded_store *store,
                           ir_c_rename rename, void *context);

#endif
