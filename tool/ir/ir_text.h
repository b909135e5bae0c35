/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Prints the IR as text: S-expressions, described in text_form.md. tests/ir_reader reads them
 *  back, so the analysis can be tested without libclang. */
#ifndef IR_IR_TEXT_H
#define IR_IR_TEXT_H

#include "ir/ir.h"
#include "support/buffer.h"

void ir_print(buffer *out, const ir_unit *unit);
void ir_print_node(buffer *out, const ir_node *node);

/** Checks the invariants stated in ir.h: child counts, parents, ids, types, and ranges nested and
 *  inside the file. Returns NULL if all hold; otherwise a message in the arena. */
const char *ir_check(arena *a, const ir_unit *unit);

/** Same as ir_check, except that ranges need not be nested: if a macro uses a parameter twice,
 *  libclang may place a node outside of its parent. */
const char *ir_check_parsed(arena *a, const ir_unit *unit);

#endif
