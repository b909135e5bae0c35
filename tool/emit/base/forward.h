/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Variables that replace elements which an iteration stores and then reads (store forwarding). */
#ifndef EMIT_BASE_FORWARD_H
#define EMIT_BASE_FORWARD_H

#include "emit/base/loop.h"

/** Declares the variables that replace elements which an iteration stores and reads again: only
 * those that the slice uses (`of_slice`), or all of them. */
void declare_forwards(loop_text *loop, writer *out, bool of_slice);
/** The variable that replaces a read of this node, or NULL. */
const char *forward_read_name(const loop_text *loop, const ir_node *node);
/** write_forward assigns the stored value to the variable. write_forwarded_store assigns the
 * variable to the element. */
void write_forward(loop_text *loop, writer *out, const forwarded_store *store, ir_c_rename rename,
                   void *context);
void write_forwarded_store(loop_text *loop, writer *out, const forwarded_store *store,
                           ir_c_rename rename, void *context);

#endif
