/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What an iteration stores into an element and reads again. */
#ifndef EMIT_BASE_FORWARD_H
#define EMIT_BASE_FORWARD_H

#include "emit/base/loop.h"

/** Declares the variables, those of the slice only or all. */
void declare_forwards(loop_text *loop, writer *out, bool of_slice);
/** The variable that this node is to be read from, or NULL. */
const char *forward_read_name(const loop_text *loop, const ir_node *node);
/** The assignment of the stored value to the variable, and from there to the element, which is a
 *  statement of its own. */
void write_forward(loop_text *loop, writer *out, const forwarded_store *store, ir_c_rename rename,
                   void *context);
void write_forwarded_store(loop_text *loop, writer *out, const forwarded_store *store,
                           ir_c_rename rename, void *context);

#endif
