/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** JSON from text that need not be UTF-8: paths and source text are bytes. */
#ifndef SUPPORT_JSON_TEXT_H
#define SUPPORT_JSON_TEXT_H

#include <jansson.h>

#include "support/buffer.h"

/** Returns a new reference to a JSON string. If the text is not UTF-8, each of its bytes that is
 * not ASCII becomes '?'. NULL becomes null. */
json_t *json_text(const char *text);
/** Appends the value with indentation and a line end; releases the reference. */
void json_print(buffer *out, json_t *value);

#endif
