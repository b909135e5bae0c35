/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The text form of the IR (tool/ir/text_form.md), read back: printing what was read gives the same
 * text. */
#ifndef IR_READER_IR_READ_H
#define IR_READER_IR_READ_H

#include "ir/ir_text.h"

/** Reads what ir_print wrote. On bad text returns NULL and puts "line:column: what was expected"
 *  into *message (in the arena). */
ir_unit *ir_read(arena *a, const char *text, size_t length, const char **message);

#endif
