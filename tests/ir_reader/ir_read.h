/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Reads the text form of the IR (tool/ir/text_form.md). Printing the result gives the same text.
 */
#ifndef IR_READER_IR_READ_H
#define IR_READER_IR_READ_H

#include "ir/ir_text.h"

/** Reads what ir_print wrote. If the text is invalid, returns NULL and sets *message to
 * "line:column: what was expected" (in the arena). */
ir_unit *ir_read(arena *a, const char *text, size_t length, const char **message);

#endif
