/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The IR as text: S-expressions (text_form.md). tests/ir_reader reads them back, so that the
 * analysis is tested without libclang.
 */
#ifndef IR_IR_TEXT_H
#define IR_IR_TEXT_H

#include "ir/ir.h"
#include "support/buffer.h"

void ir_print(buffer *out, const ir_unit *unit);
void ir_print_node(buffer *out, const ir_node *node);

/** Checks the rules stated in ir.h (child counts, parents, ids, types present, ranges nested and
 *  inside the file). Returns NULL, or a message in the arena. */
const char *ir_check(arena *a, const ir_unit *unit);

/** As ir_check, but without the nesting of ranges: if a macro uses a parameter twice, libclang may
 *  place a node outside of its parent. */
const char *ir_check_parsed(arena *a, const ir_unit *unit);

#endif
