/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Text for pages that are both HTML and XML. */
#ifndef HTML_TEXT_H
#define HTML_TEXT_H

#include <stddef.h>

#include "support/buffer.h"

/** Appends `length` bytes as text or as the value of an attribute. Bytes that are not UTF-8 are
 * read as Latin-1; & < > " ' are escaped; a character that documents may not contain becomes
 * U+FFFD. */
void html_bytes(buffer *out, const char *bytes, size_t length);
void html_text(buffer *out, const char *text);

/** Appends a section of docs/reasons.md without its heading: paragraphs, `code` in them, and blocks
 *  of code. */
void html_section(buffer *out, const char *section);

/** Appends seconds in a unit of a fitting size: "1.25 s", "3.4 ms". */
void html_seconds(buffer *out, double seconds);

#endif
