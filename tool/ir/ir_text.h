/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The IR as text, printed and read back: S-expressions, documented in docs/ir.md. Printing what
 * was read gives the same text. Passes are tested from it without libclang.
 */
#ifndef IR_IR_TEXT_H
#define IR_IR_TEXT_H

#include "ir/ir.h"
#include "support/buffer.h"

void ir_print(buffer *out, const ir_unit *unit);
void ir_print_node(buffer *out, const ir_node *node);

/** Reads what ir_print wrote. On bad text returns NULL and puts "line:column: what was expected"
 *  into *message (in the arena). */
ir_unit *ir_read(arena *a, const char *text, size_t length, const char **message);

/** Checks the rules stated in ir.h (child counts, parents, ids, types present, ranges nested and
 *  inside the file). Returns NULL, or what is wrong, in the arena. */
const char *ir_check(arena *a, const ir_unit *unit);

#endif
